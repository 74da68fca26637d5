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

struct CurvesPlot;

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
CurvesPlot precisionPlot(const std::string& title, const study::PrecisionStudy& study);

/// Plots on two panels over the tilt the flip interval, measured and by the logarithmic law, and
/// their relative difference. At least one row must have an interval.
CurvesPlot tiltPlot(const std::string& title, const study::TiltStudy& study);

/// Plots each measured quantity on a panel over the key that is varied, one curve for each value of
/// the second key. Axes over wide spans are logarithmic; a motion that doesn't diverge is an open
/// triangle at the end of its run.
CurvesPlot sweepPlot(const std::string& title, const study::SweepStudy& study,
                     const scene::Sweep& sweep);

}  // namespace rotatebook::plot
