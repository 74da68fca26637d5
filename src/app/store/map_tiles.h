// Finished tiles of a map, or frames of its film, that isn't finished.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook::store {

/// A folder of tiles, each a file that appears whole and knows what it was made from.
class MapTiles {
 public:
  /// Takes the folder, which needn't exist, and what the tiles' values depend on.
  MapTiles(std::filesystem::path folder, std::string fingerprint);

  /// The numbers of tiles in a folder.
  struct Count {
    std::size_t same = 0;   ///< With this fingerprint.
    std::size_t other = 0;  ///< With another one.
  };
  /// Counts the tiles by their first bytes alone; those without a fingerprint, as a power cut
  /// leaves them, don't count, as they are made again. Throws InputError if the folder can't be
  /// read, or holds a link or a folder in the place of a tile.
  Count count() const;

  /// Returns whether a tile with this fingerprint is there, by its first bytes alone.
  bool contains(std::size_t index) const;
  /// Returns the bytes of a tile; nothing if it isn't there, is damaged, has another fingerprint or
  /// a size other than `size`, if that is given.
  std::optional<std::string> read(std::size_t index, std::optional<std::size_t> size = {}) const;
  /// Writes a tile; the folder must exist. Throws MachineError.
  void write(std::size_t index, std::string_view bytes) const;
  /// Removes all tiles, and the folder if nothing else is in it. Throws MachineError, and
  /// InputError as count() does.
  void remove() const;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path pathOf(std::size_t index) const;

  std::filesystem::path folder_;
  std::string fingerprint_;
};

}  // namespace rotatebook::store
