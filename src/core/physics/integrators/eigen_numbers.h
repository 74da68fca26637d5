// Between Eigen's vectors and those of steps. Inside the room only.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "physics/integrators/rigid_state.h"
#include "physics/steps/step_state.h"

namespace rotatebook::physics {

inline Vector3<double> toNumbers(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
inline Eigen::Vector3d toEigen(const Vector3<double>& v) {
  return {v.x, v.y, v.z};
}
inline Eigen::Quaterniond toEigen(const Quaternion<double>& q) {
  return {q.w, q.x, q.y, q.z};
}

/// Takes a step of a quaternion: step(state) changes a StepState.
template <typename Step>
void takeStep(RigidState<Eigen::Quaterniond>& state, const Step& step) {
  const Eigen::Quaterniond& q = state.attitude;
  StepState<double> numbers{
      {q.w(), q.x(), q.y(), q.z()}, toNumbers(state.momentum), toNumbers(state.momentumCarry)};
  step(numbers);
  state = {toEigen(numbers.attitude), toEigen(numbers.momentum), toEigen(numbers.carry)};
}

/// Steps the momentum alone. Returns what step.stepMomentum() does: the turn in body axes.
template <typename Attitude, typename Step, typename Rest>
Eigen::Quaterniond takeMomentumStep(RigidState<Attitude>& state, const Step& step,
                                    const Rest& rest) {
  StepState<double> numbers{{}, toNumbers(state.momentum), toNumbers(state.momentumCarry)};
  const Quaternion<double> turn = step.stepMomentum(numbers, rest);
  state.momentum = toEigen(numbers.momentum);
  state.momentumCarry = toEigen(numbers.carry);
  return toEigen(turn);
}

}  // namespace rotatebook::physics
