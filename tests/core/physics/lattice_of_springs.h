// A small system of many springs.
#pragma once

#include <memory>

#include "physics/mass_spring_system.h"
#include "physics/scenarios.h"

namespace rotatebook::physics {

/// Returns a block of 4 x 3 x 2 particles, with springs between those within two cells.
inline MassSpringSystem block(double cell = 0.05) {
  MassSpringSystem system;
  for (int z = 0; z < 2; ++z) {
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 4; ++x) system.places.emplace_back(cell * Eigen::Vector3d(x, y, z));
    }
  }
  centre(system.places);
  const double farthest = 4.01 * cell * cell;
  for (const Spring& pair : allPairs(system.places.size())) {
    if ((system.places[pair.a] - system.places[pair.b]).squaredNorm() <= farthest)
      system.springs.push_back(pair);
  }
  return system;
}

/// Returns a motion of one kilogram of such particles.
inline MotionSettings blockMotion(const Eigen::Vector3d& spin, double h) {
  MotionSettings settings = spinning(Model::Particles, spin, h);
  settings.body.size = {0.2, 0.15, 0.1};
  settings.simulation.particles = {Arrangement::Grid, 4};
  settings.particles.system = std::make_shared<const MassSpringSystem>(block());
  return settings;
}

}  // namespace rotatebook::physics
