// Motions of rigid models whose steps others make, for several bodies at once.
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "physics/motion_settings.h"
#include "physics/simulator.h"
#include "physics/steps/any_step.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// A motion of Model::Quaternion or Model::Matrix as numbers, bit for bit those of its simulator.
class RigidMotion {
 public:
  /// The numbers of its step's State; the rest is 0.
  using State = std::array<double, kMostStateNumbers>;

  /// Returns the motion that `settings` specify, with the integrator's step between two samples;
  /// nullopt for another model, a motion with nudges or dissipation, and an integrator whose step
  /// is no template. Throws InputError as makeSimulator() does, and StepTooLong.
  static std::optional<RigidMotion> of(const MotionSettings& settings);
  /// Returns the motion with the steps of other settings, which are as `of()` takes them, and have
  /// the same body and start. Throws likewise.
  std::optional<RigidMotion> withStepsOf(const MotionSettings& settings) const;

  const rigid::PrincipalAxes& inertia() const { return axes_; }
  /// Returns the angular momentum at t = 0, along the principal axes. [kg m^2/s]
  const Eigen::Vector3d& momentum() const { return momentum_; }
  const AnyStep& step() const { return step_; }
  /// Returns the state at t = 0.
  State start() const;
  /// Returns a state for such a step in which nothing changes, if the step's own numbers are 0: the
  /// axes are the world's, and the momentum is along the first.
  State rest() const;
  /// Returns a state as the simulator reports it.
  BodyState stateOf(const State& state) const;

 private:
  RigidMotion(const rigid::PrincipalAxes& axes, const Eigen::Vector3d& momentum,
              const AnyStep& step);

  State stateFrom(const Eigen::Matrix3d& map, const Eigen::Vector3d& momentum) const;

  rigid::PrincipalAxes axes_;
  Eigen::Vector3d momentum_;  // at t = 0, along the principal axes
  AnyStep step_;
};

}  // namespace rotatebook::physics
