// The pose and the cage of particles. Inside the room only.
#pragma once

#include <Eigen/Core>

#include "body/cuboid.h"
#include "physics/mass_spring_system.h"

namespace rotatebook::physics {

/// Fits poses and cages to particles that aren't the corners of the cage. Both are linear in the
/// positions, by constant matrices.
///
/// The pose is the linear map that moves the places closest to the positions, by least squares. So
/// is the cage, among the boxes around the body that a linear map has moved and the bends x y, y z,
/// z x and x y z have bent; bends that the places hardly tell from the map, or from each other, are
/// left out. A rigid motion gives the rigid box.
class ParticleFit {
 public:
  /// The places must not lie in a plane.
  ParticleFit(const body::Cuboid& body, const MassSpringSystem& particles);

  /// Returns the linear map closest to the positions, wherever their centre is.
  Eigen::Matrix3d worldFromBody(const Eigen::Matrix3Xd& positions) const;
  /// Returns the cage of particles at these positions. [m]
  body::Cage cageOf(const Eigen::Matrix3Xd& positions) const;

 private:
  Eigen::Matrix<double, Eigen::Dynamic, 3> mapFromPositions_;
  Eigen::Matrix<double, Eigen::Dynamic, 8> cageFromPositions_;
};

}  // namespace rotatebook::physics
