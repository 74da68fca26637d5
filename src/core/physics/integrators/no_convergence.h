// The error of an implicit integrator.
#pragma once

#include "base/error.h"

namespace rotatebook::physics {

/// Reports that an implicit integrator can't solve the equations of its step, which is too long.
class NoConvergence : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace rotatebook::physics
