// The files below src/.
#pragma once

#include <filesystem>
#include <vector>

namespace rotatebook::house {

inline const std::filesystem::path kSource = std::filesystem::path(ROTATEBOOK_SOURCE) / "src";

/// Returns the headers and sources below `folder`.
inline std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") paths.push_back(entry.path());
  }
  return paths;
}

}  // namespace rotatebook::house
