#include "body/cuboid.h"

namespace rotatebook::body {
namespace {

// Returns b^2+c^2, a^2+c^2, a^2+b^2, to which both kinds of moments are proportional.
Eigen::Vector3d squaredDistancesFromAxes(const Eigen::Vector3d& size) {
  const Eigen::Vector3d squares = size.cwiseAbs2();
  return {squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y()};
}

}  // namespace

Cage Cuboid::corners() const {
  Cage result;
  for (int i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool positive = (i >> axis & 1) != 0;
      result(axis, i) = (positive ? 0.5 : -0.5) * size[axis];
    }
  }
  return result;
}

Eigen::Vector3d Cuboid::solidInertia() const {
  return mass / 12 * squaredDistancesFromAxes(size);
}

Eigen::Vector3d Cuboid::particleInertia() const {
  return mass / 4 * squaredDistancesFromAxes(size);
}

}  // namespace rotatebook::body
