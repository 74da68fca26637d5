// The steps that are templates of their number type.
#pragma once

#include <cstddef>
#include <variant>

#include "physics/steps/euler_step.h"
#include "physics/steps/midpoint_step.h"
#include "physics/steps/moser_veselov_step.h"
#include "physics/steps/runge_kutta_step.h"

namespace rotatebook::physics {

/// A step of a quaternion or matrix, of one of these types.
using AnyStep = std::variant<EulerStep<double>, RungeKutta4Step<double>, MidpointStep<double>,
                             MoserVeselovStep<double>, EulerMatrixStep<double>>;

/// Numbers in the largest of their states.
inline constexpr std::size_t kMostStateNumbers = sizeof(MatrixState<double>) / sizeof(double);
static_assert(sizeof(StepState<double>) <= sizeof(MatrixState<double>));

}  // namespace rotatebook::physics
