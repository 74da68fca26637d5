#include "page/pack_archive.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <zip.h>

#include "base/checksum.h"
#include "base/error.h"
#include "page/pack_mark.h"
#include "system/atomic_file.h"
#include "system/removal.h"
#include "system/zip_archive.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

/// Reads a file of an archive piece by piece; returns false if it is compressed or damaged, as no
/// pack's is.
template <typename Take>
bool readStored(zip_t* archive, zip_uint64_t index, const Take& take) {
  zip_stat_t stat;
  if (zip_stat_index(archive, index, 0, &stat) != 0 || stat.comp_method != ZIP_CM_STORE)
    return false;
  const system::ZippedFile file(zip_fopen_index(archive, index, 0));
  if (file == nullptr) return false;
  std::string piece(1 << 16, '\0');
  for (;;) {
    const zip_int64_t size = zip_fread(file.get(), piece.data(), piece.size());
    if (size <= 0) return size == 0;
    take(std::string_view(piece).substr(0, static_cast<std::size_t>(size)));
  }
}

/// Returns the files that an archive's mark lists; nothing if it has no mark.
std::optional<PackFiles> markIn(zip_t* archive) {
  const zip_int64_t index = zip_name_locate(archive, kPackMark, 0);
  std::string text;
  const auto take = [&text](std::string_view piece) { text += piece; };
  if (index < 0 || !readStored(archive, static_cast<zip_uint64_t>(index), take))
    return std::nullopt;
  return parsePackMark(text);
}

/// Returns the size of what an archive of stored files holds beside them. [bytes]
std::uint64_t sizeOfHeads(zip_t* archive) {
  constexpr std::uint64_t kHeads = 30 + 46, kEnd = 22;  // Of a file without its names; of all.
  const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(archive, 0));
  std::uint64_t size = kEnd;
  for (zip_uint64_t i = 0; i < count; ++i) {
    size += kHeads + 2 * std::string_view(zip_get_name(archive, i, 0)).size();
  }
  return size;
}

/// Returns whether the archive holds comments, or other bytes beside its files, of which there are
/// `stored`. Not known of one of 4 GB, whose heads are longer.
bool holdsMore(zip_t* archive, std::uint64_t stored, const fs::path& path) {
  const std::uint64_t size = fs::file_size(path);
  return size <= std::numeric_limits<std::uint32_t>::max() && size != stored + sizeOfHeads(archive);
}

bool isPackArchive(const fs::path& path) {
  if (!system::isPlainFile(path)) return false;
  const system::ZipArchive archive(zip_open(path.c_str(), ZIP_RDONLY, nullptr));
  const auto files = archive != nullptr ? markIn(archive.get()) : std::nullopt;
  if (!files) return false;
  const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(archive.get(), 0));
  std::uint64_t stored = 0;  // [bytes]
  for (zip_uint64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive.get(), i, 0);
    Checksum sum;
    const auto take = [&](std::string_view piece) {
      sum.add(piece);
      stored += piece.size();
    };
    if (name == nullptr || !readStored(archive.get(), i, take)) return false;
    if (name == std::string_view(kPackMark)) continue;
    const auto known = files->find(name);
    if (known == files->end() || !known->second.contains(sum.text())) return false;
  }
  return !holdsMore(archive.get(), stored, path);
}

}  // namespace

void writeZip(const fs::path& folder, std::vector<std::string> names, const fs::path& file) {
  names.emplace_back(kPackMark);
  std::ranges::sort(names);
  const auto repeats = std::ranges::unique(names);
  names.erase(repeats.begin(), repeats.end());
  system::AtomicFile whole(file);
  system::MemoryZip archive("can't write " + file.string());
  for (const std::string& name : names) archive.addFile(folder / name, fs::path(name).filename());
  archive.finish([&](std::string_view piece) { whole.write(piece); });
  whole.commit();
}

void requirePackArchive(const fs::path& file) {
  if (!system::isOccupied(file) || isPackArchive(file)) return;
  throw InputError("--pack: " + file.string() +
                   " isn't an archive as --pack made it, and would be replaced; name another file, "
                   "or move it away");
}

}  // namespace rotatebook::page
