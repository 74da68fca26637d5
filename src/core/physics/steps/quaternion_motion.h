// Motions of quaternions whose steps others make, for several bodies at once.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/simulator.h"
#include "physics/steps/any_step.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// A motion of Model::Quaternion as numbers, bit for bit those of its simulator.
class QuaternionMotion {
 public:
  /// Returns the motion that `settings` specify, with the integrator's step between two samples;
  /// nullopt for another model, a motion with nudges or dissipation, and an integrator whose step
  /// is no template. Throws InputError as makeSimulator() does, and StepTooLong.
  static std::optional<QuaternionMotion> of(const MotionSettings& settings);

  const rigid::PrincipalAxes& inertia() const { return axes_; }
  const AnyStep& step() const { return step_; }
  /// Returns the state at t = 0.
  StepState<double> start() const;
  /// Returns a state as the simulator reports it.
  BodyState stateOf(const StepState<double>& state) const;

 private:
  QuaternionMotion(const rigid::PrincipalAxes& axes, const Eigen::Vector3d& momentum,
                   const AnyStep& step);

  rigid::PrincipalAxes axes_;
  Eigen::Vector3d momentum_;  // at t = 0, along the principal axes
  AnyStep step_;
};

}  // namespace rotatebook::physics
