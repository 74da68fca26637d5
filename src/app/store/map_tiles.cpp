#include "store/map_tiles.h"

#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "base/checksum.h"
#include "base/error.h"
#include "system/atomic_file.h"
#include "system/read_file.h"
#include "system/temporary_files.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "tile_";

bool isTile(const fs::path& path) {
  return path.filename().string().starts_with(kPrefix);
}

std::vector<fs::path> tilesIn(const fs::path& folder) {
  std::vector<fs::path> tiles;
  if (!fs::exists(folder)) return tiles;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (isTile(entry->path())) tiles.push_back(entry->path());
  }
  if (error) throw InputError("can't read " + folder.string() + ": " + error.message());
  return tiles;
}

}  // namespace

MapTiles::MapTiles(fs::path folder, std::string fingerprint)
    : folder_(std::move(folder)), fingerprint_(std::move(fingerprint)) {}

MapTiles::Count MapTiles::count() const {
  Count count;
  for (const fs::path& tile : tilesIn(folder_)) ++(isOwn(tile) ? count.same : count.other);
  return count;
}

bool MapTiles::contains(std::size_t index) const {
  return isOwn(pathOf(index));
}

bool MapTiles::isOwn(const fs::path& tile) const {
  std::error_code missing;
  if (!fs::is_regular_file(tile, missing)) return false;
  const std::string wanted = fingerprint_ + "\n";
  std::string start(wanted.size(), '\0');
  std::ifstream(tile, std::ios::binary).read(start.data(), std::ssize(start));
  return start == wanted;
}

std::optional<std::string> MapTiles::read(std::size_t index,
                                          std::optional<std::size_t> size) const {
  std::string file = system::readFileOrEmpty(pathOf(index));
  const std::string sum = checksumOf("");  // for its length
  const std::size_t header = fingerprint_.size() + 1 + sum.size() + 1;
  if (file.size() < header || !file.starts_with(fingerprint_ + "\n")) return std::nullopt;
  if (size && file.size() != header + *size) return std::nullopt;
  const std::string stated = file.substr(fingerprint_.size() + 1, sum.size());
  std::string bytes = file.substr(header);
  if (checksumOf(bytes) != stated) return std::nullopt;
  return bytes;
}

void MapTiles::write(std::size_t index, std::string_view bytes) const {
  system::AtomicFile file(pathOf(index));
  file.write(fingerprint_ + "\n" + checksumOf(bytes) + "\n");
  file.write(bytes);
  file.commitUnflushed();  // read() knows a whole tile by its checksum
}

void MapTiles::remove() const {
  for (const fs::path& tile : tilesIn(folder_)) system::removeFile(tile);
  system::removeStaleTemporaries(folder_);
  std::error_code notEmpty;
  fs::remove(folder_, notEmpty);
}

fs::path MapTiles::pathOf(std::size_t index) const {
  return folder_ / (std::string(kPrefix) + std::to_string(index));
}

}  // namespace rotatebook::store
