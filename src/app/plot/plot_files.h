// Names of a plot's files.
#pragma once

#include <filesystem>
#include <vector>

namespace rotatebook::plot {

/// Returns the paths of a plot's files: `stem` with the ending of each format, PNG first.
std::vector<std::filesystem::path> plotFiles(const std::filesystem::path& stem);

}  // namespace rotatebook::plot
