// Draws plots with the program gnuplot.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook::picture {

/// Draws the plot of gnuplot's `commands`, which set neither terminal nor output, on a white page
/// twice as wide as high, once as SVG and once as PNG. With the variable point_size for points they
/// look alike in both. Each file is written completely or not at all. Throws MachineError if
/// gnuplot isn't installed, naming its package, or with gnuplot's message if it fails.
void drawPlot(const std::string& commands, const std::filesystem::path& svg,
              const std::filesystem::path& png);

/// Quotes `text` for gnuplot, on one line, such that nothing in it is executed; each ' becomes ’.
std::string gnuplotString(const std::string& text);

}  // namespace rotatebook::picture
