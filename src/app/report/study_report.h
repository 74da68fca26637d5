// Reports on studies.
#pragma once

#include <ostream>

#include "scene/study_settings.h"
#include "study/study.h"

namespace rotatebook::report {

// Each prints a line for each integrator or tilt and for each expectation of `study` to `out`;
// returns whether all expectations are met.

bool reportStudy(const study::PrecisionStudy& result, const scene::StudySettings& study,
                 std::ostream& out);
bool reportStudy(const study::TiltStudy& result, const scene::StudySettings& study,
                 std::ostream& out);

}  // namespace rotatebook::report
