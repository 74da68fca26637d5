#include "store/map_files.h"

namespace rotatebook::store {

MapFiles mapFiles(const std::filesystem::path& folder, const std::string& name) {
  return {folder / (name + ".png"),      folder / (name + ".plain.png"),
          folder / (name + ".npy"),      folder / (name + ".json"),
          folder / (name + ".csv"),      folder / (name + kTilesEnding),
          folder / (name + ".film.mp4"), folder / (name + ".film" + kTilesEnding)};
}

std::vector<std::filesystem::path> allOf(const MapFiles& files) {
  return {files.png, files.plain, files.npy, files.json, files.csv};
}

}  // namespace rotatebook::store
