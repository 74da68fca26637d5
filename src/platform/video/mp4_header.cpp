#include "video/mp4_header.h"

#include <algorithm>
#include <initializer_list>

#include "base/error.h"

namespace rotatebook::video {
namespace {

constexpr std::uint64_t kHead = 8;  // Of a box's size and type fields. [bytes]
constexpr std::uint64_t kMaxEdits = 16;
constexpr int kMaxBoxes = 1000;  // Limit within one box; there are ten.

/// Reads the unsigned number of `count` bytes at offset `at`; 0 beyond the end.
std::uint64_t numberAt(std::istream& file, std::uint64_t at, int count) {
  file.clear();
  file.seekg(static_cast<std::streamoff>(at));
  std::uint64_t value = 0;
  for (int i = 0; i < count; ++i) {
    const int byte = file.get();
    if (byte == std::istream::traits_type::eof()) return 0;
    value = value << 8 | static_cast<std::uint64_t>(byte);
  }
  return value;
}

/// Reads the signed 16.16 fixed-point number at offset `at`.
double fixedAt(std::istream& file, std::uint64_t at) {
  return static_cast<double>(static_cast<std::int32_t>(numberAt(file, at, 4))) / 0x1p16;
}

std::uint64_t sizeOf(std::istream& file) {
  file.clear();
  file.seekg(0, std::ios::end);
  return static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
}

/// Calls `action` with each box from offset `at` to `end`. Throws InputError if there are too many:
/// an instruction could hide behind them.
template <typename Action>
void forEachBox(std::istream& file, std::uint64_t at, std::uint64_t end, const Action& action) {
  int count = 0;
  for (auto box = mp4BoxAt(file, at, end); box; box = mp4BoxAt(file, box->end, end)) {
    if (++count > kMaxBoxes) throw InputError("too many boxes");
    action(*box);
  }
}

/// Finds the box at `path`: a box of the file, then one in it, and so on. Throws InputError if
/// there is another one, which players may obey in its place.
std::optional<Mp4Box> find(std::istream& file, std::initializer_list<std::string_view> path) {
  std::optional<Mp4Box> box = Mp4Box{"", 0, sizeOf(file)};
  for (const std::string_view type : path) {
    std::optional<Mp4Box> found;
    forEachBox(file, box->content, box->end, [&](const Mp4Box& inner) {
      if (inner.type != type) return;
      if (found) throw InputError("two boxes of one type");
      found = inner;
    });
    if (!found) return std::nullopt;
    box = found;
  }
  return box;
}

/// Returns whether the box has the longer times of version 1.
bool isLong(std::istream& file, const Mp4Box& box) {
  return numberAt(file, box.content, 1) == 1;
}

void readSize(std::istream& file, Mp4Header& header) {
  const auto box = find(file, {"moov", "trak", "tkhd"});
  if (!box) return;
  const std::uint64_t at = box->content + (isLong(file, *box) ? 88 : 76);
  header.shownWidth = fixedAt(file, at);
  header.shownHeight = fixedAt(file, at + 4);
}

/// Reads the speed and returns the ticks a second of the movie's clock.
double readSpeed(std::istream& file, Mp4Header& header) {
  const auto box = find(file, {"moov", "mvhd"});
  if (!box) return 0;
  const bool longer = isLong(file, *box);
  header.speed = fixedAt(file, box->content + (longer ? 32 : 20));
  return static_cast<double>(numberAt(file, box->content + (longer ? 20 : 12), 4));
}

void readEdits(std::istream& file, double ticks, Mp4Header& header) {
  const auto box = find(file, {"moov", "trak", "edts", "elst"});
  if (!box || ticks <= 0) return;
  const int width = isLong(file, *box) ? 8 : 4;
  const auto length = static_cast<std::uint64_t>(2 * width + 4);
  const std::uint64_t count = std::min(numberAt(file, box->content + 4, 4), kMaxEdits);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t at = box->content + kHead + i * length;
    header.edits.push_back(
        {static_cast<double>(numberAt(file, at, width)) / ticks, fixedAt(file, at + length - 4)});
  }
}

/// Looks for a clean aperture in all descriptions of the pictures.
void readCrop(std::istream& file, Mp4Header& header) {
  constexpr std::uint64_t kDescription = 78;  // Its fields before the boxes in it. [bytes]
  const auto box = find(file, {"moov", "trak", "mdia", "minf", "stbl", "stsd"});
  if (!box) return;
  header.crop = "none";
  forEachBox(file, box->content + kHead, box->end, [&](const Mp4Box& entry) {
    forEachBox(file, entry.content + kDescription, entry.end, [&](const Mp4Box& inner) {
      if (inner.type == "clap") header.crop = "clean aperture";
    });
  });
}

}  // namespace

std::optional<Mp4Box> mp4BoxAt(std::istream& file, std::uint64_t at, std::uint64_t end) {
  if (at > end || end - at < kHead) return std::nullopt;
  std::uint64_t size = numberAt(file, at, 4);
  std::string type(4, '\0');
  file.read(type.data(), 4);
  std::uint64_t head = kHead;
  if (size == 1) {
    size = numberAt(file, at + kHead, 8);
    head += 8;
  }
  if (size == 0) size = end - at;  // The last box may omit its size.
  constexpr std::uint64_t kMax = std::uint64_t{1} << 62;
  if (size < head || size > kMax) return std::nullopt;
  return Mp4Box{type, at + head, at + size};
}

Mp4Header readMp4Header(std::istream& file) try {
  Mp4Header header;
  readSize(file, header);
  readEdits(file, readSpeed(file, header), header);
  readCrop(file, header);
  return header;
} catch (const InputError&) {
  return {};
}

}  // namespace rotatebook::video
