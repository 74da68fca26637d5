// Euler's methods for the particles. Inside the room only.
#pragma once

#include "physics/integrators/particle_state.h"

namespace rotatebook::physics {

/// The paper's explicit Euler: x += h v, then v += h F(x, v)/m with the old x and v. Order 1; L
/// grows with h w^2. One evaluation of F. Stable with the paper's damping below h = 0.129
/// sqrt(m/k). Source: "Simulating the Unstable Rotation of a Book".
struct ParticleEuler {
  template <typename State>
  static void step(State& state, double h) {
    const auto acceleration = state.accelerations(state.velocities());
    state.moveTo(plus(state.positions(), h, state.velocities()));
    state.velocities() = plus(state.velocities(), h, acceleration);
  }
};

/// Symplectic Euler: v += h F(x, v)/m, then x += h v. Order 1; keeps L to rounding. One evaluation
/// of F. Stable below h = 0.707 sqrt(m/k) without damping, 0.121 with the paper's. Source: Hairer,
/// Lubich, Wanner, Geometric Numerical Integration, chapter I.
struct SymplecticEuler {
  template <typename State>
  static void step(State& state, double h) {
    state.velocities() = plus(state.velocities(), h, state.accelerations(state.velocities()));
    state.moveTo(plus(state.positions(), h, state.velocities()));
  }
};

}  // namespace rotatebook::physics
