#include "pipeline/study_files.h"

#include "base/atomic_file.h"

namespace rotatebook::pipeline {

StudyFiles studyFiles(const std::filesystem::path& folder, const std::string& name) {
  const std::string stem = name + "-study";
  return {folder / (stem + ".csv"), folder / (stem + "-orders.csv"), folder / (stem + ".svg"),
          folder / (stem + ".png")};
}

void refuseUnwritable(const StudyFiles& files) {
  for (const auto& path : {files.csv, files.orders, files.svg, files.png}) {
    const AtomicFile unused(path);
  }
}

void removeFiles(const StudyFiles& files) {
  for (const auto& path : {files.csv, files.orders, files.svg, files.png}) removeFile(path);
}

}  // namespace rotatebook::pipeline
