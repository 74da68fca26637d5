#include "store/study_files.h"

#include "base/error.h"
#include "system/atomic_file.h"
#include "system/removal.h"

namespace rotatebook::store {

std::vector<std::filesystem::path> plotFiles(const std::filesystem::path& stem) {
  return {stem.string() + ".png", stem.string() + ".svg", stem.string() + ".pdf"};
}

StudyFiles studyFiles(const std::filesystem::path& folder, const std::string& name) {
  const std::string stem = name + "-study";
  return {folder / (stem + ".csv"), plotFiles(folder / stem), folder / (stem + ".json")};
}

std::vector<std::filesystem::path> allOf(const StudyFiles& files) {
  std::vector<std::filesystem::path> all{files.csv, files.json};
  all.insert(all.end(), files.plots.begin(), files.plots.end());
  return all;
}

void requireWritable(const std::vector<std::filesystem::path>& files) {
  for (const auto& path : files) {
    const system::AtomicFile unused(path);
    const std::string obstacle = system::obstacleToRemoval(path);
    if (obstacle.empty()) continue;
    throw MachineError("can't replace " + path.string() + ": " + obstacle +
                       "; have its owner remove it, or name another folder with -o");
  }
}

void removeFiles(const std::vector<std::filesystem::path>& files) {
  for (const auto& path : files) system::removeFile(path);
}

}  // namespace rotatebook::store
