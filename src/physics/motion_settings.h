// What a motion is simulated from.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "physics/cuboid.h"

namespace rotatebook::physics {

/// The paper's three ways of simulating a book.
enum class Model {
  Particles,   ///< Eight particles joined by 28 damped springs.
  Matrix,      ///< A rigid body whose attitude is a rotation matrix.
  Quaternion,  ///< A rigid body whose attitude is a quaternion.
};

/// How a model steps through time.
enum class Integrator {
  Euler,  ///< Explicit Euler, first order.
};

/// How the motion is simulated.
struct SimulationSettings {
  Model model = Model::Quaternion;
  Integrator integrator = Integrator::Euler;
  /// Undo the integrator's drift after each step: the energy of the particles, the shape of the
  /// rigid models.
  bool normalize = true;
  /// Particles only: fraction of the paper's critical damping 2 sqrt(k m), >= 0.
  double damping = 1.0;
  double stiffness = 2000.0;       ///< Particles only: of each spring, > 0. [N/m]
  double timePerFrame = 1.0 / 60;  ///< From a sample of the trajectory to the next, > 0. [s]
  int substeps = 64;               ///< Integration steps from a sample to the next, >= 1.
};

/// Turns a vector by `angle` toward a coordinate axis.
struct Tilt {
  double angle = 0;  ///< [rad]
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
  /// The angular velocity of a body with these principal moments. [rad/s]
  Eigen::Vector3d angularVelocity(const Eigen::Vector3d& inertia) const;
};

/// Everything that a motion depends on.
struct MotionSettings {
  Cuboid body;
  SimulationSettings simulation;
  InitialSpin initial;
};

}  // namespace rotatebook::physics
