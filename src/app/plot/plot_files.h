// A plot's file.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook::plot {

/// A plot in one format.
struct PlotFile {
  std::filesystem::path path;
  std::string bytes;
};

}  // namespace rotatebook::plot
