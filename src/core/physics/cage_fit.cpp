#include "physics/cage_fit.h"

#include <Eigen/LU>

namespace rotatebook::physics {

CageFit::CageFit(const body::Cuboid& body) {
  const body::Cage corners = body.corners();
  const Eigen::Matrix3d products = corners * corners.transpose();
  mapFromCage_ = corners.transpose() * products.inverse();
}

}  // namespace rotatebook::physics
