// Steps of implicit integrators that iteration doesn't solve. Inside the room only.
#pragma once

#include "physics/steps/branch.h"

namespace rotatebook::physics {

/// Throws NoConvergence: `integrator` finds no solution for a step of `h` [s].
[[noreturn]] void throwNoConvergence(const char* integrator, double h);

/// Solves steps by Newton's method. Throws NoConvergence where the solution that belongs to short
/// steps has ended.
struct SolvedOrThrown {
  const char* integrator;
  double h;  ///< [s]

  template <typename Equation, typename Iterated>
  Vector3<double> operator()(const Equation& equation, const Iterated& /*iterated*/) const {
    if (const auto found = followedBranch(equation)) return *found;
    throwNoConvergence(integrator, h);
  }
  [[noreturn]] Vector3<double> unsolved(const Vector3<double>& /*x*/, bool /*condition*/) const {
    throwNoConvergence(integrator, h);
  }
};

}  // namespace rotatebook::physics
