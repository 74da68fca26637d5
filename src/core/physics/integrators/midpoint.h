// The implicit midpoint rule for a rigid body. Inside the room only.
#pragma once

#include <cmath>

#include "physics/attitude.h"
#include "physics/integrators/implicit_step.h"
#include "physics/integrators/rigid_state.h"
#include "rigid/rotation.h"

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
    const Eigen::Vector3d middle =
        solveStep(state.momentum, Equation{*this, state.momentum}, "midpoint", h_);
    const Eigen::Vector3d half = h_ / 2 * body_.inverseInertia.cwiseProduct(middle);
    if (!std::isfinite(half.squaredNorm())) throwNoConvergence("midpoint", h_);
    turnInBody(state.attitude, Eigen::Quaterniond(1, half.x(), half.y(), half.z()).normalized());
    addCompensated(2 * middle.cross(half), state.momentum, state.momentumCarry);
  }

 private:
  /// Mm = M + share (h/2) Mm x w.
  struct Equation {
    const Midpoint& rule;
    const Eigen::Vector3d& momentum;

    const Eigen::Vector3d& solutionAtZero() const { return momentum; }
    Eigen::Vector3d next(const Eigen::Vector3d& middle, double share) const {
      return momentum +
             share * rule.h_ / 2 * middle.cross(rule.body_.inverseInertia.cwiseProduct(middle));
    }
    Eigen::Matrix3d derivative(const Eigen::Vector3d& middle, double share) const {
      const Eigen::Vector3d velocity = rule.body_.inverseInertia.cwiseProduct(middle);
      return share * rule.h_ / 2 *
             (rigid::crossMatrix(middle) * rule.body_.inverseInertia.asDiagonal() -
              rigid::crossMatrix(velocity));
    }
  };

  RigidConstants body_;
  double h_;
};

}  // namespace rotatebook::physics
