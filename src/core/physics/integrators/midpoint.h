// The implicit midpoint rule for a rigid body.
#pragma once

#include "physics/attitude.h"
#include "physics/integrators/implicit_step.h"
#include "physics/integrators/rigid_state.h"

namespace rotatebook::physics {

/// Solves Mm = M + (h/2) Mm x w with w = I^-1 Mm; then M <- 2 Mm - M, and the attitude turns by the
/// Cayley transform of h w. Order 2; keeps the energy, L and the rotation to rounding, because all
/// are quadratic; symplectic up to a reparametrisation of time. Throws NoConvergence. Source:
/// Austin, Krishnaprasad, Wang, Journal of Computational Physics 107 (1993).
class Midpoint {
 public:
  static constexpr bool kMomentumInBody = true;

  Midpoint(const RigidConstants& body, double h) : body_(body), h_(h) {}

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    const Eigen::Vector3d& momentum = state.momentum;
    const auto next = [&](const Eigen::Vector3d& middle) -> Eigen::Vector3d {
      return momentum + h_ / 2 * middle.cross(body_.inverseInertia.cwiseProduct(middle));
    };
    const Eigen::Vector3d middle = fixedPoint(momentum, next, "midpoint", h_);
    const Eigen::Vector3d half = h_ / 2 * body_.inverseInertia.cwiseProduct(middle);
    turnInBody(state.attitude, Eigen::Quaterniond(1, half.x(), half.y(), half.z()).normalized());
    state.momentum = 2 * middle - momentum;
  }

 private:
  RigidConstants body_;
  double h_;
};

}  // namespace rotatebook::physics
