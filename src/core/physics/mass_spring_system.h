// Particles of equal mass in a body, and the springs between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "rigid/inertia.h"

namespace rotatebook::physics {

/// The most particles that a body may have.
inline constexpr std::size_t kMaxParticles = 2000;

/// Ways to put particles into a body.
enum class Arrangement {
  Corners,       ///< The paper's: eight at the corners of a box, each pair joined by a spring.
  Equimomental,  ///< Eight with the rigid body's moments, each pair joined by a spring.
  Vertices,      ///< One at each vertex of the body's surface.
  Grid,          ///< At the points of a lattice that are inside the body.
};

/// The arrangement that a scene asks for.
struct ParticleSettings {
  Arrangement arrangement = Arrangement::Corners;
  int cells = 0;  ///< Of Arrangement::Grid, along the body's longest side; else 0.

  friend bool operator==(const ParticleSettings&, const ParticleSettings&) = default;
};

/// Returns whether the arrangement has eight particles, each pair joined by a spring.
constexpr bool areEight(Arrangement arrangement) {
  return arrangement == Arrangement::Corners || arrangement == Arrangement::Equimomental;
}

/// A spring, by the numbers of the particles at its ends.
struct Spring {
  std::uint32_t a = 0, b = 0;

  friend bool operator==(const Spring&, const Spring&) = default;
};

/// Particles of equal mass at rest, and the springs that join them.
struct MassSpringSystem {
  std::vector<Eigen::Vector3d> places;  ///< From their centre of mass, in body axes. [m]
  std::vector<Spring> springs;

  /// Returns the inertia tensor of particles that have this `mass` together. [kg m^2]
  Eigen::Matrix3d inertia(double mass) const;

  friend bool operator==(const MassSpringSystem&, const MassSpringSystem&) = default;
};

/// A system that follows from a body's surface, made by who has the surface.
struct PlacedParticles {
  std::shared_ptr<const MassSpringSystem> system{};  ///< Null for the arrangements of eight.
  std::optional<rigid::Inertia> inertia{};           ///< Of the system with the body's mass.

  friend bool operator==(const PlacedParticles& a, const PlacedParticles& b) {
    return a.system == b.system || (a.system && b.system && *a.system == *b.system);
  }
};

/// Returns particles that have this `mass` together. [kg]
PlacedParticles placed(MassSpringSystem system, double mass);

/// Returns the springs between all pairs of `count` particles.
std::vector<Spring> allPairs(std::size_t count);

/// Moves the places by their mean to the origin, which becomes their centre of mass.
void centre(std::vector<Eigen::Vector3d>& places);

}  // namespace rotatebook::physics
