// The velocity Verlet method for the particles. Inside the room only.
#pragma once

#include "physics/integrators/particle_state.h"

namespace rotatebook::physics {

/// Velocity Verlet: half a step of v, x += h v, then the other half of v at the new x, with dampers
/// at the velocity v + h F/m. Order 2; keeps L to rounding. Two evaluations of F. Stable below h =
/// 0.707 sqrt(m/k) without damping, 0.125 with the paper's. Source: Hairer, Lubich, Wanner,
/// Geometric Numerical Integration, chapter I.
struct Verlet {
  template <typename State>
  static void step(State& state, double h) {
    const auto before = state.accelerations(state.velocities());
    const auto predicted = plus(state.velocities(), h, before);
    state.velocities() = plus(state.velocities(), h / 2, before);
    state.moveTo(plus(state.positions(), h, state.velocities()));
    state.velocities() = plus(state.velocities(), h / 2, state.accelerations(predicted));
  }
};

}  // namespace rotatebook::physics
