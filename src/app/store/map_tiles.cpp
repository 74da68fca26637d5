#include "store/map_tiles.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/checksum.h"
#include "base/error.h"
#include "system/atomic_file.h"
#include "system/read_file.h"
#include "system/removal.h"
#include "system/temporary_files.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTilePrefix = "tile_";

/// Returns whether write() gives a file this name: tile_0, tile_17.
bool isTile(const fs::path& path) {
  const std::string name = path.filename().string();
  if (!name.starts_with(kTilePrefix) || name.size() == kTilePrefix.size()) return false;
  return std::all_of(name.begin() + std::ssize(kTilePrefix), name.end(),
                     [](char letter) { return '0' <= letter && letter <= '9'; });
}

/// Throws InputError for a link or a folder in the place of a tile.
void requireFile(const fs::path& tile) {
  if (system::isPlainFile(tile)) return;
  throw InputError(tile.string() +
                   " is a link, a folder or a device, and no tile that was left here; remove it");
}

std::vector<fs::path> tilesIn(const fs::path& folder) {
  std::vector<fs::path> tiles;
  if (!fs::exists(folder)) return tiles;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (!isTile(entry->path())) continue;
    requireFile(entry->path());
    tiles.push_back(entry->path());
  }
  if (error) throw InputError(fmt::format("can't read {}: {}", folder.string(), error.message()));
  return tiles;
}

/// Returns the fingerprint that a tile begins with, a line; empty of one that a power cut left
/// without, or that isn't there.
std::string fingerprintIn(const fs::path& tile) {
  if (!system::isPlainFile(tile)) return "";
  constexpr std::size_t kLongestFingerprint = 200;
  std::string start(kLongestFingerprint, '\0');
  std::ifstream file(tile, std::ios::binary);
  file.read(start.data(), std::ssize(start));
  start.resize(static_cast<std::size_t>(file.gcount()));
  const std::size_t end = start.find('\n');
  const std::string line = start.substr(0, end);
  return end != start.npos && line.find('\0') == line.npos ? line : "";
}

}  // namespace

MapTiles::MapTiles(fs::path folder, std::string fingerprint)
    : folder_(std::move(folder)), fingerprint_(std::move(fingerprint)) {}

MapTiles::Count MapTiles::count() const {
  Count count;
  for (const fs::path& tile : tilesIn(folder_)) {
    const std::string stated = fingerprintIn(tile);
    if (stated == fingerprint_)
      ++count.same;
    else if (!stated.empty())
      ++count.other;
  }
  return count;
}

bool MapTiles::contains(std::size_t index) const {
  return fingerprintIn(pathOf(index)) == fingerprint_;
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
  file.write(fmt::format("{}\n{}\n", fingerprint_, checksumOf(bytes)));
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
  return folder_ / fmt::format("{}{}", kTilePrefix, index);
}

}  // namespace rotatebook::store
