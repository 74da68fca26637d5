// The settings from which a motion is simulated.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "base/layout.h"
#include "body/cuboid.h"
#include "physics/integrators/integrator.h"
#include "physics/mass_spring_system.h"
#include "physics/nudge.h"
#include "physics/recorded_file.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {

/// The paper's three models of a book, the exact motion, and one that was recorded.
enum class Model {
  Particles,   ///< Particles joined by damped springs; the paper's eight by 28.
  Matrix,      ///< A rigid body whose attitude is a rotation matrix.
  Quaternion,  ///< A rigid body whose attitude is a quaternion.
  Exact,       ///< A rigid body's motion in closed form, without steps.
  Recorded,    ///< A motion from a file: measured, or made by another program.
};

/// Returns whether `model` integrates, step by step.
constexpr bool takesSteps(Model model) {
  return model != Model::Exact && model != Model::Recorded;
}

/// Returns the integrators that `model` has; none for a model that takes no steps.
std::vector<Integrator> integratorsOf(Model model);
/// Returns whether `model` has `integrator`.
bool isFor(Model model, Integrator integrator);
/// Returns whether `model`, stepped by `integrator`, takes SimulationSettings::dissipation.
bool takesDissipation(Model model, Integrator integrator);
/// Returns the integrator that `model` uses if a scene states none: Rk4 for the rigid models, which
/// stay close to the exact motion with it; for the particles Euler, the paper's. Models
/// that take no steps don't use it.
Integrator defaultIntegrator(Model model);

/// Integration steps of one length, one after another.
struct EqualSteps {
  double time;  ///< Of all of them together, > 0. [s]
  int count;    ///< >= 1

  double length() const { return time / count; }  ///< [s]
};

/// The model of a motion, and the steps by which it is simulated.
struct SimulationSettings {
  Model model = Model::Quaternion;
  /// One of integratorsOf(model); unused by models that take no steps.
  Integrator integrator = defaultIntegrator(model);
  /// Steps from one undoing of the integrator's drift to the next, counted from the start; 0 for
  /// none. Of the shape of the rigid models; of the particles' energy and centre, unless the two
  /// below say otherwise.
  int normalizeEvery = 1;
  /// Particles only: likewise, of the energy alone.
  std::optional<int> normalizeEnergyEvery{};
  /// Particles only: likewise, of the position and velocity of the centre of mass alone.
  std::optional<int> removeDriftEvery{};
  /// Particles only: fraction of the paper's critical damping 2 sqrt(k m), >= 0.
  double damping = 1.0;
  double stiffness = 2000.0;       ///< Particles only: stiffness of each spring, > 0. [N/m]
  double timePerFrame = 1.0 / 60;  ///< Time between samples of the trajectory, > 0. [s]
  int substeps = 64;               ///< Integration steps in `substepped`, >= 1.
  /// Time that `substeps` divide, whatever the samples; without it, timePerFrame. [s]
  std::optional<double> substepped{};
  std::optional<double> step{};  ///< Length of a step, in place of `substeps`, > 0. [s]
  RecordedFile recorded{};       ///< Of Model::Recorded alone.
  ParticleSettings particles{};  ///< Particles only: where they are.
  /// Model::Matrix and Model::Quaternion only: what a damper inside takes, see
  /// RigidConstants::dissipation, >= 0. [kg m^2 s]
  double dissipation = 0;

  /// Returns the steps that the motion repeats from its start on, whatever its samples.
  EqualSteps steps() const {
    if (step) return {*step, 1};
    return {substepped.value_or(timePerFrame), substeps};
  }
  /// Returns whether a rigid body's energy has a sink.
  bool dissipates() const {
    return dissipation > 0 && (model == Model::Matrix || model == Model::Quaternion);
  }
  /// Returns the steps from one normalisation of the particles' energy to the next; 0 for none.
  int energyEvery() const { return normalizeEnergyEvery.value_or(normalizeEvery); }
  /// Returns the steps from one removal of the particles' drift to the next; 0 for none.
  int driftEvery() const { return removeDriftEvery.value_or(normalizeEvery); }

  friend bool operator==(const SimulationSettings&, const SimulationSettings&) = default;
};

/// A rotation of a vector by `angle` toward a coordinate axis.
struct Tilt {
  double angle = 0;  ///< From -kLargestAngle to kLargestAngle. [rad]
  int axis = 0;      ///< 0, 1, 2: x, y, z

  friend bool operator==(const Tilt&, const Tilt&) = default;
};

/// A spin about a principal axis, chosen by its moment.
struct SpinAbout {
  int rank = 0;     ///< 0, 1, 2: the axis of the smallest, middle and largest moment.
  double rate = 0;  ///< In the unit of InitialSpin::value, not 0.

  friend bool operator==(const SpinAbout&, const SpinAbout&) = default;
};

/// The spin at t = 0, along the body's axes, and the body's attitude then.
struct InitialSpin {
  using Kind = SpinKind;

  Kind kind = Kind::AngularVelocity;
  Eigen::Vector3d value{0, 0, 0};  ///< Not zero. [rad/s] or [kg m^2/s]
  std::optional<Tilt> tilt{};      ///< Applied to `value` before use.
  /// The source of `value`, if a scene names the axis.
  std::optional<SpinAbout> about{};
  /// The quaternion w, x, y, z that turns the body's axes into the world's, of any length but 0.
  /// Without one they coincide. It turns the motion as a whole.
  std::optional<Eigen::Vector4d> attitude{};

  /// Returns `value` rotated by `tilt`. Throws InputError if it points along the tilt's axis, where
  /// no rotation is defined.
  Eigen::Vector3d tilted() const;
  /// Returns the angular velocity of a body with this inertia, in body axes. [rad/s]
  Eigen::Vector3d angularVelocity(const rigid::PrincipalAxes& inertia) const;
  /// Like angularVelocity(), but along the principal axes and in double-double numbers. [rad/s]
  DoubleDouble3 alongPrincipal(const rigid::PrincipalAxes& inertia) const;

  friend bool operator==(const InitialSpin&, const InitialSpin&) = default;
};

/// Everything that a motion depends on.
struct MotionSettings {
  body::Cuboid body;
  SimulationSettings simulation;
  InitialSpin initial;
  /// Replaces the solid cuboid's. Of all particles,
  /// Arrangement::Equimomental alone takes it; the others have their own. [kg m^2]
  std::optional<rigid::Inertia> inertia{};
  PlacedParticles particles{};  ///< Of Arrangement::Vertices and Arrangement::Grid.
  std::vector<Nudge> nudges{};  ///< In the order of their times.

  friend bool operator==(const MotionSettings&, const MotionSettings&) = default;
};

extern const std::size_t kMotionSettingsSize;  // in the library
namespace {
[[maybe_unused]] const bool kMotionSettingsIsSame =
    noteSize("physics::MotionSettings", kMotionSettingsSize, sizeof(MotionSettings));
}  // namespace

}  // namespace rotatebook::physics
