// What a motion is simulated from.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "physics/cuboid.h"
#include "physics/inertia.h"
#include "physics/integrators/integrator.h"

namespace rotatebook::physics {

/// The paper's three ways of simulating a book, and the truth.
enum class Model {
  Particles,   ///< Eight particles joined by 28 damped springs.
  Matrix,      ///< A rigid body whose attitude is a rotation matrix.
  Quaternion,  ///< A rigid body whose attitude is a quaternion.
  Exact,       ///< A rigid body's motion in closed form, without steps.
};

/// The integrators that `model` has, none for Model::Exact.
std::vector<Integrator> integratorsOf(Model model);
/// Whether `integrator` is one of them.
bool isFor(Model model, Integrator integrator);
/// The integrator of `model` unless a scene states one: Rk4 for the rigid models, which then stay
/// close to the exact motion; for the particles Euler, the paper's. Model::Exact doesn't use it.
Integrator defaultIntegrator(Model model);

/// How the motion is simulated.
struct SimulationSettings {
  Model model = Model::Quaternion;
  /// One of integratorsOf(model); unused by Model::Exact.
  Integrator integrator = defaultIntegrator(model);
  /// Undo the integrator's drift after each step: the energy of the particles, the shape of the
  /// rigid models.
  bool normalize = true;
  /// Particles only: fraction of the paper's critical damping 2 sqrt(k m), >= 0.
  double damping = 1.0;
  double stiffness = 2000.0;       ///< Particles only: of each spring, > 0. [N/m]
  double timePerFrame = 1.0 / 60;  ///< From a sample of the trajectory to the next, > 0. [s]
  int substeps = 64;               ///< Integration steps from a sample to the next, >= 1.

  friend bool operator==(const SimulationSettings&, const SimulationSettings&) = default;
};

/// Turns a vector by `angle` toward a coordinate axis.
struct Tilt {
  double angle = 0;  ///< Of a size up to kLargestAngle. [rad]
  int axis = 0;      ///< 0, 1, 2: x, y, z

  friend bool operator==(const Tilt&, const Tilt&) = default;
};

/// The spin at t = 0, when body and world axes agree.
struct InitialSpin {
  enum class Kind { AngularVelocity, AngularMomentum };

  Kind kind = Kind::AngularVelocity;
  Eigen::Vector3d value{0, 0, 0};  ///< Not zero. [rad/s] or [kg m^2/s]
  std::optional<Tilt> tilt{};      ///< Turns `value` before use.

  /// `value` turned by `tilt`. Throws InputError if it points along the tilt's axis, where no turn
  /// is defined.
  Eigen::Vector3d tilted() const;
  /// The angular velocity of a body with this inertia. [rad/s]
  Eigen::Vector3d angularVelocity(const PrincipalAxes& inertia) const;
  /// The same along the principal axes, to twice a double's precision. [rad/s]
  DoubleDouble3 alongPrincipal(const PrincipalAxes& inertia) const;

  friend bool operator==(const InitialSpin&, const InitialSpin&) = default;
};

/// Everything that a motion depends on.
struct MotionSettings {
  Cuboid body;
  SimulationSettings simulation;
  InitialSpin initial;
  /// Tensor about the body's axes, in place of the solid cuboid's. Not for the particles, which
  /// have their own. [kg m^2]
  std::optional<Eigen::Matrix3d> inertia{};

  friend bool operator==(const MotionSettings&, const MotionSettings&) = default;
};

}  // namespace rotatebook::physics
