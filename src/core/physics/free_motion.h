// Samples as those of a free motion.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "physics/nudge.h"
#include "physics/sample.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// Returns the angular momentum along the principal axes. [kg m^2/s]
Eigen::Vector3d momentumAlong(const rigid::PrincipalAxes& axes, const Sample& sample);

/// Returns the numbers of the samples from which a body moves freely: the first, and those just
/// after nudges, which are in the order of time.
std::vector<std::size_t> freeStarts(std::span<const Sample> samples, std::span<const Nudge> nudges);

}  // namespace rotatebook::physics
