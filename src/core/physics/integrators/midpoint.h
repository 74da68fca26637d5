// The implicit midpoint rule for a rigid body. Inside the room only.
#pragma once

#include "physics/attitude.h"
#include "physics/integrators/eigen_numbers.h"
#include "physics/integrators/implicit_step.h"
#include "physics/integrators/rigid_state.h"
#include "physics/steps/midpoint_step.h"

namespace rotatebook::physics {

/// Solves Mm = M + (h/2) Mm x w with w = I^-1 Mm; then M <- 2 Mm - M, and the attitude turns by the
/// Cayley transform of h w. Order 2; keeps the energy, L and the rotation to rounding, because all
/// are quadratic; symplectic up to a reparametrisation of time. Throws NoConvergence. Source:
/// Austin, Krishnaprasad, Wang, Journal of Computational Physics 107 (1993).
class Midpoint {
 public:
  static constexpr bool kMomentumInBody = true;

  Midpoint(const RigidConstants& body, double h) : step_(stepOf(body, h)) {}

  /// Returns the step for numbers, of length h [s].
  static MidpointStep<double> stepOf(const RigidConstants& body, double h) {
    return {toNumbers(body.inverseInertia), h};
  }

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    turnInBody(state.attitude, takeMomentumStep(state, step_, SolvedOrThrown{"midpoint", step_.h}));
  }

 private:
  MidpointStep<double> step_;
};

}  // namespace rotatebook::physics
