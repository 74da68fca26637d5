// The error of an implicit integrator.
#pragma once

#include "base/error.h"

namespace rotatebook::physics {

/// An implicit integrator can't solve the equations of its step, because the step is too long.
class NoConvergence : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace rotatebook::physics
