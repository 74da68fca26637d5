// The classical Runge-Kutta method for the particles. Inside the room only.
#pragma once

#include "physics/integrators/particle_state.h"

namespace rotatebook::physics {

/// Runge and Kutta's classical method on positions and velocities. Order 4; keeps nothing exactly.
/// Four evaluations of F. Stable below h = 1.000 sqrt(m/k) without damping, 0.180 with the paper's.
/// Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, table II.1.2.
struct ParticleRungeKutta4 {
  template <typename State>
  static void step(State& state, double h) {
    const auto x = state.positions(), v1 = state.velocities();
    const auto a1 = state.accelerations(v1);
    state.moveTo(plus(x, h / 2, v1));
    const auto v2 = plus(v1, h / 2, a1);
    const auto a2 = state.accelerations(v2);
    state.moveTo(plus(x, h / 2, v2));
    const auto v3 = plus(v1, h / 2, a2);
    const auto a3 = state.accelerations(v3);
    state.moveTo(plus(x, h, v3));
    const auto v4 = plus(v1, h, a3);
    const auto a4 = state.accelerations(v4);

    const auto outer = plus(v1, 1, v4), inner = plus(v2, 1, v3);
    state.moveTo(plus(plus(x, h / 6, outer), h / 3, inner));
    state.velocities() = plus(state.velocities(), h / 6, plus(a1, 1, a4));
    state.velocities() = plus(state.velocities(), h / 3, plus(a2, 1, a3));
  }
};

}  // namespace rotatebook::physics
