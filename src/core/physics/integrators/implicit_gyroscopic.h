// The rule of game engines that solve for the gyroscopic torque at the end of the step. Inside the
// room only.
#pragma once

#include <Eigen/Geometry>

#include "physics/attitude.h"
#include "physics/integrators/exponential.h"
#include "physics/integrators/rigid_state.h"

namespace rotatebook::physics {

/// Implicit Euler in body axes, I (w' - w) + h w' x I w' = 0, by one step of Newton's method from
/// w' = w: w' = w - J^-1 h w x I w with J = I + h ([w]x I - [I w]x). Then the body turns by h w'.
/// Order 1; keeps the rotation to rounding; loses energy and angular momentum. One exponential and
/// one system of three equations per step.
///
/// Emulates the documented rule, in double precision and without damping, of: Erin Catto, Numerical
/// Methods, Game Developers Conference 2015; Bullet's BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY
/// (btRigidBody::computeGyroscopicImpulseImplicit_Body), its default since 2.83.
class ImplicitGyroscopic {
 public:
  static constexpr bool kMomentumInBody = true;

  ImplicitGyroscopic(const RigidConstants& body, double h) : body_(body), h_(h) {}

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    const Eigen::Vector3d& before = state.momentum;
    const Eigen::Vector3d w = body_.inverseInertia.cwiseProduct(before);
    Eigen::Matrix3d jacobian =
        h_ * (rigid::crossMatrix(w) * body_.inertia.asDiagonal() - rigid::crossMatrix(before));
    jacobian.diagonal() += body_.inertia;
    const Eigen::Vector3d after = w - solved(jacobian, h_ * w.cross(before));
    state.momentum = body_.inertia.cwiseProduct(after);
    turnInBody(state.attitude, rotationBy(h_ * after));
  }

 private:
  // Solves the system by Cramer's rule.
  static Eigen::Vector3d solved(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& right) {
    const Eigen::Vector3d a = matrix.col(0), b = matrix.col(1), c = matrix.col(2);
    const Eigen::Vector3d across = b.cross(c);
    return Eigen::Vector3d(right.dot(across), a.dot(right.cross(c)), a.dot(b.cross(right))) /
           a.dot(across);
  }

  RigidConstants body_;
  double h_;
};

}  // namespace rotatebook::physics
