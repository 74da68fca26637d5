// Search for scenes on the disk.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace rotatebook::store {

/// The scenes below a folder.
struct FoundScenes {
  std::vector<std::filesystem::path> paths;  ///< Sorted.
  /// Folders that can't be listed, with "can't list FOLDER: WHY"; sorted.
  std::vector<std::pair<std::filesystem::path, std::string>> problems;
};

/// Finds the scenes below `folder`, without the records that renders leave. Throws InputError if
/// `folder` itself can't be listed.
FoundScenes scenesBelow(const std::filesystem::path& folder);

}  // namespace rotatebook::store
