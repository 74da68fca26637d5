// A plot's files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rotatebook::plot {

/// A plot in one format.
struct PlotFile {
  std::filesystem::path path;
  std::string bytes;
};

/// Returns the paths of a plot's files: `stem` with the ending of each format, PNG first.
std::vector<std::filesystem::path> plotFiles(const std::filesystem::path& stem);

}  // namespace rotatebook::plot
