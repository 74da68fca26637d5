// The state of the particles, on which their integrators work. Inside the room only.
#pragma once

#include <concepts>

#include "physics/many_springs.h"
#include "physics/spring_network.h"

namespace rotatebook::physics {

/// Particles of equal mass, and the `Springs` between them: SpringNetwork of eight, ManySprings of
/// any number.
template <typename Springs>
class BasicParticleState {
 public:
  using Points = typename Springs::Points;

  /// Creates particles of `mass` each [kg] at `positions` [m] with `velocities` [m/s], joined by
  /// `springs`, whose ends must be at those positions.
  BasicParticleState(const Points& positions, const Points& velocities, double mass,
                     const Springs& springs)
      : positions_(positions), velocities_(velocities), mass_(mass), springs_(springs) {}

  const Points& positions() const { return positions_; }    ///< [m]
  const Points& velocities() const { return velocities_; }  ///< [m/s]
  Points& velocities() { return velocities_; }              ///< [m/s]
  double mass() const { return mass_; }                     ///< Mass of one particle. [kg]
  double kineticEnergy() const { return mass_ / 2 * squaredNormOf(velocities_); }  ///< [J]
  double potentialEnergy() const { return springs_.energy(); }                     ///< [J]

  /// Returns the particles' accelerations at their positions, but at these velocities. [m/s^2]
  Points accelerations(const Points& velocities) const {
    Points result = springs_.forces(velocities);
    scale(result, 1 / mass_);
    return result;
  }
  /// Moves the particles, and the ends of the springs with them. [m]
  void moveTo(const Points& positions) {
    positions_ = positions;
    springs_.moveTo(positions_);
  }
  /// Moves the centre of mass to the origin and brings it to rest. The springs depend on
  /// differences of positions alone.
  void restoreCentre() {
    subtractMean(positions_);
    subtractMean(velocities_);
  }

 private:
  Points positions_;
  Points velocities_;
  double mass_;
  Springs springs_;
};

using ParticleState = BasicParticleState<SpringNetwork>;
using ManyParticleState = BasicParticleState<ManySprings>;

/// A function that takes a step of `h` [s].
template <typename Springs>
using BasicParticleStep = void (*)(BasicParticleState<Springs>& state, double h);

/// An integrator of the particles: its step() takes a step of `h` [s] of any state.
template <typename Method>
concept ParticleIntegrator = requires(ParticleState& eight, ManyParticleState& many, double h) {
  { Method::step(eight, h) } -> std::same_as<void>;
  { Method::step(many, h) } -> std::same_as<void>;
};

}  // namespace rotatebook::physics
