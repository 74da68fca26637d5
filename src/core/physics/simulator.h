// The interface that all models implement.
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

#include "base/layout.h"
#include "body/cuboid.h"
#include "physics/nudge.h"

namespace rotatebook::physics {

/// The state of a body at one moment, as its model reports it: a pose and, if the body is deformed,
/// a cage; world axes, SI units.
struct BodyState {
  /// The linear map that the model's attitude represents: a rotation, or what drift has made of
  /// one; for a deformed body, the map that best fits its cage.
  Eigen::Matrix3d worldFromBody = Eigen::Matrix3d::Identity();
  /// Corners of a deformed body; nullopt if worldFromBody determines them. [m]
  std::optional<body::Cage> cage{};
  Eigen::Vector3d angularVelocity{0, 0, 0};  ///< [rad/s]
  Eigen::Vector3d angularMomentum{0, 0, 0};  ///< About the centre of mass. [kg m^2/s]
  double kinetic = 0;                        ///< [J]
  double potential = 0;                      ///< Energy in the springs; 0 for a rigid body. [J]
  double rotational = 0;  ///< Kinetic energy of the best-fitting rigid motion, w.L/2. [J]
};

/// Returns the corners of `body` in this state, as they are drawn. [m]
inline body::Cage drawnCage(const BodyState& state, const body::Cuboid& body) {
  return state.cage ? *state.cage : body::Cage(state.worldFromBody * body.corners());
}

/// A body in motion. Starts at t = 0, when body and world axes coincide.
class Simulator {
 public:
  virtual ~Simulator() = default;

  /// Advances by `interval` > 0 in `steps` equal integration steps. [s] Throws StepError.
  virtual void advance(double interval, int steps) = 0;
  /// Advances by a part > 0 of a step, the rest of which is to follow. [s] It doesn't count as a
  /// step: what is corrected after every so many steps isn't corrected after it.
  virtual void advancePart(double part) = 0;
  /// Goes to `time`, forward or back, and returns true, if the model takes no steps. [s]
  virtual bool jumpTo(double /*time*/) { return false; }
  /// Adds a nudge's change to the spin of the body as it is now, whatever the time of the nudge.
  virtual void nudge(const Nudge& nudge) = 0;
  /// Returns a copy, which goes on by itself.
  virtual std::unique_ptr<Simulator> copy() const = 0;
  /// Returns the current state. Its numbers need not be finite once a motion has blown up.
  virtual BodyState state() const = 0;
};

extern const std::size_t kBodyStateSize;  // in the library
namespace {
[[maybe_unused]] const bool kBodyStateIsSame =
    noteSize("physics::BodyState", kBodyStateSize, sizeof(BodyState));
}  // namespace

}  // namespace rotatebook::physics
