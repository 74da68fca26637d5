// Splitting methods: a rigid body that turns about one principal axis at a time. Inside the room
// only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/attitude.h"
#include "physics/integrators/exponential.h"
#include "physics/integrators/rigid_state.h"

namespace rotatebook::physics {

/// Splits the energy into its terms M_k^2 / (2 I_k); the motion of each alone is a turn by h M_k /
/// I_k about axis k. The turns are composed symmetrically, from the axis of smallest inertia to
/// that of the largest and back: for a book this order is up to 18 times more accurate than x, y,
/// z. Order 2; keeps L and the rotation to rounding, and the energy without drift; symplectic; five
/// turns per step. Source: McLachlan 1993; Touma and Wisdom 1994; Dullweber, Leimkuhler, McLachlan
/// 1997.
class Splitting {
 public:
  static constexpr bool kMomentumInBody = true;

  Splitting(const RigidConstants& body, double h) : inverseInertia_(body.inverseInertia), h_(h) {
    std::ranges::stable_sort(axes_, {}, [&](int axis) { return body.inertia[axis]; });
  }

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    step(state, h_);
  }

  /// Takes a step of another length, which may be negative. [s]
  template <typename Attitude>
  void step(RigidState<Attitude>& state, double h) const {
    const auto [smallest, middle, largest] = axes_;
    turn(state, smallest, h / 2);
    turn(state, middle, h / 2);
    turn(state, largest, h);
    turn(state, middle, h / 2);
    turn(state, smallest, h / 2);
  }

 private:
  template <typename Attitude>
  void turn(RigidState<Attitude>& state, int axis, double h) const {
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
    rotation[axis] = h * inverseInertia_[axis] * state.momentum[axis];
    const Eigen::Quaterniond turn = rotationBy(rotation);
    turnInBody(state.attitude, turn);

    const double sine = 2 * turn.w() * turn.vec()[axis];
    const double cosine = 1 - 2 * turn.vec()[axis] * turn.vec()[axis];
    double& next = state.momentum[(axis + 1) % 3];
    double& last = state.momentum[(axis + 2) % 3];
    const double before = next;
    next = cosine * before + sine * last;
    last = cosine * last - sine * before;
  }

  Eigen::Vector3d inverseInertia_;
  double h_;
  std::array<int, 3> axes_{0, 1, 2};  // smallest inertia first
};

/// Five splitting steps of lengths g h, g h, (1 - 4 g) h, g h, g h with g = 1 / (4 - 4^(1/3)).
/// Order 4; keeps what the splitting keeps. Source: Suzuki, Physics Letters A 146 (1990).
class Suzuki4 {
 public:
  static constexpr bool kMomentumInBody = Splitting::kMomentumInBody;

  Suzuki4(const RigidConstants& body, double h) : splitting_(body, h), h_(h) {}

  template <typename Attitude>
  void step(RigidState<Attitude>& state) const {
    for (const double part : {kOuter, kOuter, 1 - 4 * kOuter, kOuter, kOuter}) {
      splitting_.step(state, part * h_);
    }
  }

 private:
  static constexpr double kOuter = 0.41449077179437573714;

  Splitting splitting_;
  double h_;
};

}  // namespace rotatebook::physics
