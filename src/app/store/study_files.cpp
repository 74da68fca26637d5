#include "store/study_files.h"

#include "system/atomic_file.h"

namespace rotatebook::store {

StudyFiles studyFiles(const std::filesystem::path& folder, const std::string& name) {
  const std::string stem = name + "-study";
  return {folder / (stem + ".csv"), folder / (stem + "-orders.csv"), folder / (stem + ".svg"),
          folder / (stem + ".png")};
}

std::vector<std::filesystem::path> allOf(const StudyFiles& files) {
  return {files.csv, files.orders, files.svg, files.png};
}

void requireWritable(const StudyFiles& files) {
  for (const auto& path : allOf(files)) {
    const system::AtomicFile unused(path);
  }
}

void removeFiles(const StudyFiles& files) {
  for (const auto& path : allOf(files)) system::removeFile(path);
}

}  // namespace rotatebook::store
