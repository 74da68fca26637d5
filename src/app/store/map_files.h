// Names of the files that a map leaves on the disk.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rotatebook::store {

/// The ending of the folder of an unfinished map's tiles; no scene's name may end in it.
inline constexpr const char* kTilesEnding = ".tiles";

/// Paths of a map's outputs, all in one folder.
struct MapFiles {
  /// NAME.png and other formats, plotFiles(), with axes and legend
  std::vector<std::filesystem::path> plots;
  std::filesystem::path plain;       ///< NAME.plain.png, one pixel a run
  std::filesystem::path npy;         ///< NAME.npy, the values
  std::filesystem::path json;        ///< NAME.json, the axes
  std::filesystem::path csv;         ///< NAME.csv, only of small maps
  std::filesystem::path tiles;       ///< NAME.tiles/, while the map is made
  std::filesystem::path film;        ///< NAME.film.mp4
  std::filesystem::path filmFrames;  ///< NAME.film.tiles/, while the film is made

  const std::filesystem::path& png() const { return plots.front(); }
};

/// Returns the paths of the map `name` in `folder`.
MapFiles mapFiles(const std::filesystem::path& folder, const std::string& name);

/// Returns all files of the map itself.
std::vector<std::filesystem::path> allOf(const MapFiles& files);

/// Returns study::MapChecksums::fingerprint of the map that left the files; empty if none did.
std::string mapFingerprintIn(const MapFiles& files);

}  // namespace rotatebook::store
