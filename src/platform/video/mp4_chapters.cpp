#include "video/mp4_chapters.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>

#include "base/clip_parts.h"
#include "base/error.h"
#include "base/text.h"
#include "video/layout.h"

namespace rotatebook::video {
namespace {

constexpr std::size_t kLongestName = 255;  // [bytes]
constexpr std::uint64_t kHead = 8;         // Of a box. [bytes]

/// Returns the first letters of a name that its length in one byte can count.
std::string_view shortened(std::string_view name) {
  while (name.size() > kLongestName) name = firstCharacters(name, characterCount(name) - 1);
  return name;
}

/// An MP4 whose index is changed.
class Index {
 public:
  explicit Index(const std::filesystem::path& path)
      : file_(path, std::ios::binary | std::ios::in | std::ios::out), size_(sizeOf(file_)) {}

  /// Inserts a box at the end of "moov/udta"; returns whether the file could be changed.
  bool insert(const std::string& box) {
    const std::optional<Part> moov = child("moov", 0, size_);
    if (!moov) return false;
    const std::optional<Part> udta = child("udta", moov->content, moov->end);
    if (!udta || udta->end != moov->end) return false;
    if (!moveChunks(*moov, box.size())) return false;
    grow(*udta, box.size());
    grow(*moov, box.size());
    makeRoom(moov->end, box.size());
    put(moov->end, box);
    file_.flush();
    return file_.good();
  }

 private:
  std::optional<Part> child(std::string_view id, std::uint64_t from, std::uint64_t end) {
    std::optional<Part> box = partAt(file_, mp4Box, from, end);
    while (box && box->id != id) box = partAt(file_, mp4Box, box->end, end);
    return box;
  }

  /// Adds `by` to the offsets of the pictures, which come after the index.
  bool moveChunks(const Part& moov, std::uint64_t by) {
    std::optional<Part> box = moov;
    for (const std::string_view id : {"trak", "mdia", "minf", "stbl"})
      if (box) box = child(id, box->content, box->end);
    if (!box) return false;
    const std::optional<Part> shortOnes = child("stco", box->content, box->end);
    const std::optional<Part> chunks =
        shortOnes ? shortOnes : child("co64", box->content, box->end);
    if (!chunks) return false;
    const int each = shortOnes ? 4 : 8;
    std::string table = bytesAt(file_, chunks->content, chunks->end - chunks->content);
    for (std::size_t at = 2 * 4; at + static_cast<std::size_t>(each) <= table.size();
         at += static_cast<std::size_t>(each)) {
      const std::uint64_t offset =
          bigEndian(std::string_view(table).substr(at, static_cast<std::size_t>(each))) + by;
      if (each == 4 && offset >> 32 != 0) return false;
      table.replace(at, static_cast<std::size_t>(each), bigEndianBytes(offset, each));
    }
    put(chunks->content, table);
    return true;
  }

  void grow(const Part& box, std::uint64_t by) {
    put(box.start, bigEndianBytes(box.end - box.start + by, 4));
  }

  /// Moves all bytes from `at` on by `by`, the last ones first.
  void makeRoom(std::uint64_t at, std::uint64_t by) {
    constexpr std::uint64_t kPiece = 1 << 20;
    for (std::uint64_t end = size_; end > at;) {
      const std::uint64_t begin = std::max(at, end - std::min(end, kPiece));
      put(begin + by, bytesAt(file_, begin, end - begin));
      end = begin;
    }
  }

  void put(std::uint64_t at, const std::string& bytes) {
    file_.clear();
    file_.seekp(static_cast<std::streamoff>(at));
    file_.write(bytes.data(), std::ssize(bytes));
  }

  std::fstream file_;
  std::uint64_t size_;
};

}  // namespace

std::string chapterList(const std::vector<Chapter>& chapters, FrameRate rate) {
  constexpr std::int64_t kTicks = 10'000'000;  // a second
  const std::size_t count = std::min(chapters.size(), kMostChapters);
  std::string list("\1\0\0\0\0\0\0\0", 8);  // version and flags; reserved
  list += static_cast<char>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view name = shortened(chapters[i].name);
    const std::int64_t time = chapters[i].frame * rate.denominator * kTicks / rate.numerator;
    list += bigEndianBytes(static_cast<std::uint64_t>(time), 8);
    list += static_cast<char>(name.size());
    list += name;
  }
  return list;
}

void addChapters(const std::filesystem::path& mp4, const std::vector<Chapter>& chapters,
                 FrameRate rate) {
  if (chapters.empty()) return;
  const std::string list = chapterList(chapters, rate);
  if (!Index(mp4).insert(bigEndianBytes(list.size() + kHead, 4) + "chpl" + list))
    throw MachineError("can't write the chapters of " + mp4.string());
}

}  // namespace rotatebook::video
