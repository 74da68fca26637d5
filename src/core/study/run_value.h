// The value of a run of a map, where it is no number.
#pragma once

#include <limits>

#include "scene/map_settings.h"

namespace rotatebook::study {

inline constexpr double kNever = std::numeric_limits<double>::infinity();
inline constexpr double kDiverged = -kNever;
/// There is no such body or spin, or the integrator can't make such a step.
inline constexpr double kRefused = std::numeric_limits<double>::quiet_NaN();

/// Returns the kind of a run's value.
scene::Outcome outcomeOf(double value);

}  // namespace rotatebook::study
