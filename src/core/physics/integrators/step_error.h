// The errors of integrators whose step is too long.
#pragma once

#include "base/error.h"

namespace rotatebook::physics {

/// Reports that an integrator can't make its step, which is too long.
class StepError : public InputError {
 public:
  using InputError::InputError;
};

/// Reports that an implicit integrator finds no solution for its step.
class NoConvergence : public StepError {
 public:
  using StepError::StepError;
};

/// Reports a step outside the reach of its integrator's series.
class StepTooLong : public StepError {
 public:
  using StepError::StepError;
};

}  // namespace rotatebook::physics
