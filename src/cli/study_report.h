// What a study found, in words.
#pragma once

#include <ostream>

#include "pipeline/study.h"
#include "scene/study_settings.h"

namespace rotatebook::cli {

// Each prints a line an integrator or tilt to `out`, and one an expectation of `study`; returns
// kDone if all are met, else kUnmet.

int reportStudy(const pipeline::PrecisionStudy& result, const scene::StudySettings& study,
                std::ostream& out);
int reportStudy(const pipeline::TiltStudy& result, const scene::StudySettings& study,
                std::ostream& out);

}  // namespace rotatebook::cli
