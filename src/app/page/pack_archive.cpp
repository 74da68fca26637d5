#include "page/pack_archive.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <zip.h>

#include "base/checksum.h"
#include "base/error.h"
#include "page/pack_mark.h"
#include "system/atomic_file.h"
#include "system/removal.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

using Archive = std::unique_ptr<zip_t, decltype([](zip_t* archive) { zip_discard(archive); })>;
using ArchivedFile = std::unique_ptr<zip_file_t, decltype([](zip_file_t* f) { zip_fclose(f); })>;

using Source = std::unique_ptr<zip_source_t, decltype([](zip_source_t* s) { zip_source_free(s); })>;

[[noreturn]] void failZip(const fs::path& file, const char* cause) {
  throw MachineError("can't write " + file.string() + ": " + cause);
}

void addToZip(zip_t* archive, const fs::path& from, const fs::path& zip) {
  zip_source_t* source = zip_source_file(archive, from.c_str(), 0, -1);
  if (source == nullptr) failZip(zip, zip_strerror(archive));
  const zip_int64_t index =
      zip_file_add(archive, from.filename().c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    failZip(zip, zip_strerror(archive));
  }
  const auto entry = static_cast<zip_uint64_t>(index);
  // 1980-01-01 00:00, the first day of a ZIP's clock.
  if (zip_set_file_compression(archive, entry, ZIP_CM_STORE, 0) != 0 ||
      zip_file_set_dostime(archive, entry, 0, (1 << 5) | 1, 0) != 0) {
    failZip(zip, zip_strerror(archive));
  }
}

/// Appends the bytes of an archive in memory to a file.
void appendTo(system::AtomicFile& file, zip_source_t* archive) {
  const auto fail = [&] {
    failZip(file.finalPath(), zip_error_strerror(zip_source_error(archive)));
  };
  if (zip_source_open(archive) != 0) fail();
  std::string piece(1 << 16, '\0');
  for (;;) {
    const zip_int64_t size = zip_source_read(archive, piece.data(), piece.size());
    if (size < 0) fail();
    if (size == 0) break;
    file.write(std::string_view(piece).substr(0, static_cast<std::size_t>(size)));
  }
  zip_source_close(archive);
}

/// Reads a file of an archive piece by piece; returns false if it is compressed or damaged, as no
/// pack's is.
template <typename Take>
bool readStored(zip_t* archive, zip_uint64_t index, const Take& take) {
  zip_stat_t stat;
  if (zip_stat_index(archive, index, 0, &stat) != 0 || stat.comp_method != ZIP_CM_STORE)
    return false;
  const ArchivedFile file(zip_fopen_index(archive, index, 0));
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
  const Archive archive(zip_open(path.c_str(), ZIP_RDONLY, nullptr));
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
  // In memory: libzip doesn't flush files of its own, and a kill would leave them
  const Source buffer(zip_source_buffer_create(nullptr, 0, 0, nullptr));
  if (buffer == nullptr) failZip(file, "libzip can't begin it");
  Archive archive(zip_open_from_source(buffer.get(), ZIP_CREATE | ZIP_TRUNCATE, nullptr));
  if (archive == nullptr) failZip(file, "libzip can't begin it");
  zip_source_keep(buffer.get());  // The archive frees it, too.
  for (const std::string& name : names) addToZip(archive.get(), folder / name, file);
  if (zip_close(archive.get()) != 0) failZip(file, zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // zip_close() has freed it.
  appendTo(whole, buffer.get());
  whole.commit();
}

void requirePackArchive(const fs::path& file) {
  if (!system::isOccupied(file) || isPackArchive(file)) return;
  throw InputError("--pack: " + file.string() +
                   " isn't an archive as --pack made it, and would be replaced; name another file, "
                   "or move it away");
}

}  // namespace rotatebook::page
