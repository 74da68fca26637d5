// Solutions of implicit steps that iteration doesn't find.
#pragma once

#include <optional>

#include "physics/steps/midpoint_step.h"
#include "physics/steps/moser_veselov_step.h"

namespace rotatebook::physics {

/// Follows the solution from share 0, where it is known, to the whole step by Newton's method.
/// Returns nothing where the branch of solutions that belongs to short steps has ended before.
std::optional<Vector3<double>> followedBranch(const MidpointEquation<double>& equation);
std::optional<Vector3<double>> followedBranch(const MoserVeselovEquation<double>& equation);

}  // namespace rotatebook::physics
