// Plots of the results of studies.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plot/plot_files.h"
#include "scene/scene.h"
#include "study/study.h"

namespace rotatebook::plot {

struct Plot;

/// Throws InputError if the font of the scene lacks a letter of its study's texts: before the runs
/// rather than after.
void requireStudyLetters(const scene::Scene& scene);

/// Draws the results of the study of `scene` in the formats that the files end in.
std::vector<PlotFile> studyPlot(const study::Study& result, const scene::Scene& scene,
                                const std::vector<std::filesystem::path>& files);

/// Plots each measured quantity on a panel over the key that is varied, one curve for each value of
/// the second key. Axes over wide spans are logarithmic; what doesn't happen is an open triangle at
/// the end of its run. An order has two panels with logarithmic axes: the largest error over the
/// step, and over the computing time of one second of motion, with grey lines whose slopes are the
/// rounded fitted orders, of which at least one run must have completed.
Plot plotOf(const study::Study& result, const scene::StudySettings& study);

}  // namespace rotatebook::plot
