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
inline Quaternion<double> toNumbers(const Eigen::Quaterniond& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}
inline Eigen::Quaterniond toEigen(const Quaternion<double>& q) {
  return {q.w, q.x, q.y, q.z};
}
inline Matrix3<double> toColumns(const Eigen::Matrix3d& m) {
  return {toNumbers(m.col(0)), toNumbers(m.col(1)), toNumbers(m.col(2))};
}
inline Eigen::Matrix3d toEigen(const Matrix3<double>& m) {
  Eigen::Matrix3d result;
  result << toEigen(m.x), toEigen(m.y), toEigen(m.z);
  return result;
}

/// Takes a step of a quaternion: step(state) changes a StepState.
template <typename Step>
void takeStep(RigidState<Eigen::Quaterniond>& state, const Step& step) {
  StepState<double> numbers{toNumbers(state.attitude), toNumbers(state.momentum),
                            toNumbers(state.momentumCarry)};
  step(numbers);
  state = {toEigen(numbers.attitude), toEigen(numbers.momentum), toEigen(numbers.carry)};
}

/// Takes likewise a step of a matrix, which leaves the momentum as it is.
template <typename Step>
void takeStep(RigidState<Eigen::Matrix3d>& state, const Step& step) {
  MatrixState<double> numbers{toColumns(state.attitude), toNumbers(state.momentum)};
  step(numbers);
  state.attitude = toEigen(numbers.attitude);
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
