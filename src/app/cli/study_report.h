// What a study found, in words. Inside the room only.
#pragma once

#include <ostream>

#include "scene/study_settings.h"
#include "study/study.h"

namespace rotatebook::cli {

// Each prints a line an integrator or tilt to `out`, and one an expectation of `study`; returns
// kDone if all are met, else kUnmet.

int reportStudy(const study::PrecisionStudy& result, const scene::StudySettings& study,
                std::ostream& out);
int reportStudy(const study::TiltStudy& result, const scene::StudySettings& study,
                std::ostream& out);

}  // namespace rotatebook::cli
