// A map as a plot: title, legend, axes, marks and caption.
#pragma once

#include <filesystem>
#include <vector>

#include "image/image.h"
#include "plot/plot_files.h"
#include "scene/scene.h"
#include "study/map_result.h"

namespace rotatebook::plot {

class Drawing;

/// Throws InputError if the font of the scene lacks a letter of the map's texts: before the runs
/// rather than after.
void requireMapLetters(const scene::Scene& scene);

/// Draws the map of `scene`, which has one, on dark ground: a pixel, or a square of pixels, for
/// each run; of a very large map only some of the runs. Panels are side by side. The sheet is at
/// least `leastWidth` wide; of maps that differ in the ranges of their axes alone, all else is at
/// the same distance from the right. Both sides are even. Throws like requireMapLetters().
Drawing drawMap(const study::MapResult& result, const scene::Scene& scene, int leastWidth = 0);

/// Returns that drawing's pixels.
image::Image mapPicture(const study::MapResult& result, const scene::Scene& scene,
                        int leastWidth = 0);
/// Returns that drawing in the formats that the files end in.
std::vector<PlotFile> mapPlot(const study::MapResult& result, const scene::Scene& scene,
                              const std::vector<std::filesystem::path>& files);

/// Returns the width of that sheet, which the ticks' labels decide, too. [pixels]
int mapWidth(const scene::Scene& scene);

}  // namespace rotatebook::plot
