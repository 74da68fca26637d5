#include "physics/particle_places.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace rotatebook::physics {
namespace {

rigid::PrincipalAxes rigidInertia(const MotionSettings& settings) {
  if (settings.inertia) return settings.inertia->axes();
  return {settings.body.solidInertia()};
}

MassSpringSystem cornersOf(const body::Cuboid& body) {
  MassSpringSystem system{{}, allPairs(8)};
  const body::Cage corners = body.corners();
  for (const auto& corner : corners.colwise()) system.places.emplace_back(corner);
  return system;
}

}  // namespace

std::vector<Eigen::Vector3d> equimomentalPlaces(const rigid::PrincipalAxes& inertia, double mass) {
  Eigen::Vector3d arms;
  for (int i = 0; i < 3; ++i) {
    const auto& moments = inertia.moments;
    const double others = moments[(i + 1) % 3] + moments[(i + 2) % 3];
    arms[i] = std::sqrt(std::max(0.0, (others - moments[i]) / (2 * mass)));
  }
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 8; ++i) {
    Eigen::Vector3d along = arms;
    for (int axis = 0; axis < 3; ++axis) {
      if ((i >> axis & 1) == 0) along[axis] = -along[axis];
    }
    places.emplace_back(inertia.bodyFromPrincipal * along);
  }
  return places;
}

MassSpringSystem particlesOf(const MotionSettings& settings) {
  switch (settings.simulation.particles.arrangement) {
    case Arrangement::Corners:
      return cornersOf(settings.body);
    case Arrangement::Equimomental:
      return {equimomentalPlaces(rigidInertia(settings), settings.body.mass), allPairs(8)};
    case Arrangement::Vertices:
    case Arrangement::Grid:
      break;
  }
  if (settings.particles.system == nullptr)
    throw InputError("the particles of this motion haven't been placed in a surface");
  return *settings.particles.system;
}

}  // namespace rotatebook::physics
