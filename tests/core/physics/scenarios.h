// Motions that several tests share.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Core>

#include "physics/make_simulator.h"
#include "physics/motion_settings.h"
#include "physics/motion_start.h"
#include "physics/simulate.h"

namespace rotatebook::physics {

/// Rate of the spin in every Scenario: one turn a second. [rad/s]
inline constexpr double kSpinRate = 2 * std::numbers::pi;

/// A motion of the default book by explicit Euler, in the paper's dimensionless numbers. It starts
/// with an angular momentum along (1, slant, slant), the 1 being that of `axis`, and as large as
/// kSpinRate about that axis makes it.
struct Scenario {
  Model model = Model::Quaternion;
  int axis = 0;  ///< 0, 1, 2: x (middle moment of inertia), y (smallest), z (largest)
  double slant = 0;
  bool normalize = true;
  double damping = 1;   ///< Fraction of the paper's critical damping.
  double kappa = 759;   ///< Stiffness / (mass of a particle * kSpinRate^2).
  double eta = 0.0019;  ///< kSpinRate * step.
  int substeps = 40;    ///< Steps from a sample to the next.
};

inline MotionSettings settingsOf(const Scenario& scenario) {
  MotionSettings settings;
  settings.simulation.model = scenario.model;
  settings.simulation.integrator = Integrator::Euler;
  settings.simulation.normalizeEvery = scenario.normalize ? 1 : 0;
  settings.simulation.damping = scenario.damping;
  settings.simulation.stiffness = scenario.kappa * settings.body.mass / 8 * kSpinRate * kSpinRate;
  settings.simulation.substeps = scenario.substeps;
  settings.simulation.timePerFrame = scenario.substeps * scenario.eta / kSpinRate;

  Eigen::Vector3d direction = Eigen::Vector3d::Constant(scenario.slant);
  direction[scenario.axis] = 1;
  settings.initial.kind = InitialSpin::Kind::AngularMomentum;
  settings.initial.value = modelInertia(settings).moments[scenario.axis] * kSpinRate * direction;
  return settings;
}

/// Simulates `scenario` until kSpinRate * time is `angle`. [rad]
inline Trajectory simulate(const Scenario& scenario, double angle) {
  const double samples = angle / (scenario.substeps * scenario.eta);
  return simulate(settingsOf(scenario), 1 + static_cast<std::int64_t>(std::ceil(samples)));
}

/// A book of one kilogram that spins at `angularVelocity` [rad/s] in Euler's steps of `h` [s].
inline MotionSettings spinning(Model model, const Eigen::Vector3d& angularVelocity, double h) {
  MotionSettings settings;
  settings.simulation.model = model;
  settings.simulation.integrator = Integrator::Euler;
  settings.simulation.substeps = 1;
  settings.simulation.timePerFrame = h;
  settings.initial.value = angularVelocity;
  return settings;
}

}  // namespace rotatebook::physics
