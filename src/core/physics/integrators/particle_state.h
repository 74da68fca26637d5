// The state of the particles, on which their integrators work. Inside the room only.
#pragma once

#include <concepts>

#include "physics/spring_network.h"

namespace rotatebook::physics {

/// Eight particles of equal mass, and the springs between them.
class ParticleState {
 public:
  /// Creates particles of `mass` each [kg] at `positions` [m] with `velocities` [m/s], joined by
  /// `springs`, whose ends must be at those positions.
  ParticleState(const Points& positions, const Points& velocities, double mass,
                const SpringNetwork& springs)
      : positions_(positions), velocities_(velocities), mass_(mass), springs_(springs) {}

  const Points& positions() const { return positions_; }    ///< [m]
  const Points& velocities() const { return velocities_; }  ///< [m/s]
  Points& velocities() { return velocities_; }              ///< [m/s]
  double mass() const { return mass_; }                     ///< Mass of one particle. [kg]
  double kineticEnergy() const { return mass_ / 2 * squaredNormOf(velocities_); }  ///< [J]
  double potentialEnergy() const { return springs_.energy(); }                     ///< [J]

  /// Returns the particles' accelerations at their positions, but at these velocities. [m/s^2]
  Points accelerations(const Points& velocities) const;
  /// Moves the particles, and the ends of the springs with them. [m]
  void moveTo(const Points& positions);
  /// Moves the centre of mass to the origin and brings it to rest.
  void restoreCentre();

 private:
  Points positions_;
  Points velocities_;
  double mass_;
  SpringNetwork springs_;
};

/// A function that takes a step of `h` [s].
using ParticleStep = void (*)(ParticleState& state, double h);

/// An integrator of the particles: its step() takes a step of `h` [s].
template <typename Method>
concept ParticleIntegrator = requires(ParticleState& state, double h) {
  { Method::step(state, h) } -> std::same_as<void>;
};

}  // namespace rotatebook::physics
