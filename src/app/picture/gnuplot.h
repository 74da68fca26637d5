// Pictures of plots, drawn by the program gnuplot.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook::picture {

/// Draws `commands`, gnuplot's without a terminal or an output, on a white sheet twice as wide as
/// high: once as SVG, once as PNG. Its variable point_size is what looks alike in both. Each file
/// is whole or not there. Throws MachineError if gnuplot isn't installed, naming its package, or
/// with gnuplot's own words if it fails.
void drawPlot(const std::string& commands, const std::filesystem::path& svg,
              const std::filesystem::path& png);

/// `text` as gnuplot quotes it, on one line, which runs nothing; with ’ for each '.
std::string gnuplotString(const std::string& text);

}  // namespace rotatebook::picture
