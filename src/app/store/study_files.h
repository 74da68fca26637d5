// Names of the files that a study leaves on the disk.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rotatebook::store {

/// Paths of a study's outputs, all in one folder.
struct StudyFiles {
  std::filesystem::path csv;                 ///< NAME-study.csv
  std::vector<std::filesystem::path> plots;  ///< NAME-study.png and others, plotFiles()
  std::filesystem::path json;                ///< NAME-study.json
};

/// Returns the paths of a plot's files: `stem` with the ending of each format, PNG first.
std::vector<std::filesystem::path> plotFiles(const std::filesystem::path& stem);

/// Returns the paths of the study `name` in `folder`.
StudyFiles studyFiles(const std::filesystem::path& folder, const std::string& name);

/// Returns all of `files`.
std::vector<std::filesystem::path> allOf(const StudyFiles& files);

/// Throws MachineError, without changing anything, if one of the files can't be written, so that a
/// study or a map fails before it runs rather than after.
void requireWritable(const std::vector<std::filesystem::path>& files);

/// Removes the files of an earlier study or map, so that two never mix. Throws MachineError.
void removeFiles(const std::vector<std::filesystem::path>& files);

}  // namespace rotatebook::store
