// Names of what a study leaves on the disk.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook::store {

struct StudyFiles {
  std::filesystem::path csv;     ///< NAME-study.csv
  std::filesystem::path orders;  ///< NAME-study-orders.csv, of integrators only
  std::filesystem::path svg;     ///< NAME-study.svg
  std::filesystem::path png;     ///< NAME-study.png
};

/// The files of the study `name` in `folder`.
StudyFiles studyFiles(const std::filesystem::path& folder, const std::string& name);

/// Throws MachineError, and leaves everything as it is, if one of them can't be written: better
/// before a study than after.
void refuseUnwritable(const StudyFiles& files);

/// Removes those of an earlier study, so that files of two never mix. Throws MachineError.
void removeFiles(const StudyFiles& files);

}  // namespace rotatebook::store
