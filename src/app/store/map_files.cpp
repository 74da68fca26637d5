#include "store/map_files.h"

#include "store/study_files.h"
#include "study/map_files.h"
#include "system/read_file.h"

namespace rotatebook::store {

MapFiles mapFiles(const std::filesystem::path& folder, const std::string& name) {
  return {plotFiles(folder / name),      folder / (name + ".plain.png"),
          folder / (name + ".npy"),      folder / (name + ".json"),
          folder / (name + ".csv"),      folder / (name + kTilesEnding),
          folder / (name + ".film.mp4"), folder / (name + ".film" + kTilesEnding)};
}

std::vector<std::filesystem::path> allOf(const MapFiles& files) {
  std::vector<std::filesystem::path> all = files.plots;
  all.insert(all.end(), {files.plain, files.npy, files.json, files.csv});
  return all;
}

std::string mapFingerprintIn(const MapFiles& files) {
  return study::checksumsIn(system::readFileOrEmpty(files.json)).fingerprint;
}

}  // namespace rotatebook::store
