// The pose of a deformed body. Inside the room only.
#pragma once

#include <Eigen/Core>

#include "body/cuboid.h"

namespace rotatebook::physics {

/// Fits linear maps to the cages of one body, by least squares over its eight corners.
class CageFit {
 public:
  explicit CageFit(const body::Cuboid& body);

  /// Returns the linear map of the body that is closest to `cage`, wherever its centre is.
  Eigen::Matrix3d worldFromBody(const body::Cage& cage) const { return cage * mapFromCage_; }

 private:
  Eigen::Matrix<double, 8, 3> mapFromCage_;  // C^T (C C^T)^-1 of the body's corners C
};

}  // namespace rotatebook::physics
