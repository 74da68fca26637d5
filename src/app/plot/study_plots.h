// Plots of the results of studies.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "scene/scene.h"
#include "study/study.h"
#include "study/sweep.h"

namespace rotatebook::plot {

struct Plot;

/// The results of any study.
using StudyResult = std::variant<study::PrecisionStudy, study::TiltStudy, study::SweepStudy>;

/// Throws InputError if the font of the scene lacks a letter of the study's texts: before the runs
/// rather than after.
void requireStudyLetters(const scene::Scene& scene, const scene::StudySettings& study);

/// Draws the results of the study of `scene`, and writes them like writePlot().
void writeStudyPlot(const StudyResult& result, const scene::Scene& scene,
                    const scene::StudySettings& study,
                    const std::vector<std::filesystem::path>& files);

/// Plots on two panels with logarithmic axes the largest error over the step, and over the
/// computing time of one second of motion, with grey lines whose slopes are the rounded fitted
/// orders. Runs that didn't complete are left out; at least one run must have.
Plot plotOf(const study::PrecisionStudy& result, const scene::StudySettings& study);

/// Plots on two panels over the tilt the flip interval, measured and by the logarithmic law, and
/// their relative difference. At least one row must have an interval.
Plot plotOf(const study::TiltStudy& result, const scene::StudySettings& study);

/// Plots each measured quantity on a panel over the key that is varied, one curve for each value of
/// the second key. Axes over wide spans are logarithmic; a motion that doesn't diverge is an open
/// triangle at the end of its run.
Plot plotOf(const study::SweepStudy& result, const scene::StudySettings& study);

}  // namespace rotatebook::plot
