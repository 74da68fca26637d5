// The errors of integrators whose step is too long.
#pragma once

#include "base/error.h"

namespace rotatebook::physics {

/// Reports that an integrator can't make its step, which is too long.
struct StepError : InputError {
  using InputError::InputError;
};

/// Reports that an implicit integrator finds no solution for its step.
struct NoConvergence : StepError {
  using StepError::StepError;
};

/// Reports a step outside the reach of its integrator's series.
struct StepTooLong : StepError {
  using StepError::StepError;
};

}  // namespace rotatebook::physics
