// Reports on studies. Inside the room only.
#pragma once

#include <ostream>

#include "scene/study_settings.h"
#include "study/study.h"

namespace rotatebook::cli {

// Each prints a line for each integrator or tilt and for each expectation of `study` to `out`;
// returns kDone if all expectations are met, else kUnmet.

int reportStudy(const study::PrecisionStudy& result, const scene::StudySettings& study,
                std::ostream& out);
int reportStudy(const study::TiltStudy& result, const scene::StudySettings& study,
                std::ostream& out);

}  // namespace rotatebook::cli
