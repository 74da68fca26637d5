#include "physics/particle_fit.h"

#include <Eigen/LU>

namespace rotatebook::physics {
namespace {

constexpr int kFunctions = 8, kLinear = 4;
// Share of a bend's squares that the places must tell from the functions before it.
constexpr double kTold = 0.01;

using Values = Eigen::Matrix<double, kFunctions, Eigen::Dynamic>;

// Sums over particles are lazy products: the order of sums in a product by blocks follows from the
// processor's caches.

/// Returns 1, x, y, z, x y, y z, z x and x y z of each point, in halves of the body's size.
Values functionsAt(const Eigen::Matrix3Xd& points, const body::Cuboid& body) {
  Values values(kFunctions, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d p = (2 * points.col(i)).cwiseQuotient(body.size);
    values.col(i) << 1, p.x(), p.y(), p.z(), p.x() * p.y(), p.y() * p.z(), p.z() * p.x(),
        p.x() * p.y() * p.z();
  }
  return values;
}

}  // namespace

ParticleFit::ParticleFit(const body::Cuboid& body, const MassSpringSystem& particles) {
  const auto count = static_cast<Eigen::Index>(particles.places.size());
  Eigen::Matrix3Xd places(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    places.col(i) = particles.places[static_cast<std::size_t>(i)];
  const Eigen::Matrix3d products = places.lazyProduct(places.transpose());
  mapFromPositions_ = places.transpose().lazyProduct(products.inverse().eval());

  // Make the functions orthogonal at the places (Gram and Schmidt), and follow them at the corners
  Values here = functionsAt(places, body), there = functionsAt(body.corners(), body);
  cageFromPositions_.setZero(count, 8);
  for (int i = 0; i < kFunctions; ++i) {
    const double whole = here.row(i).squaredNorm();
    for (int j = 0; j < i; ++j) {
      const double squares = here.row(j).squaredNorm();
      if (squares == 0) continue;
      const double share = here.row(i).dot(here.row(j)) / squares;
      here.row(i) -= share * here.row(j);
      there.row(i) -= share * there.row(j);
    }
    const double told = here.row(i).squaredNorm();
    if (i >= kLinear && told <= kTold * whole) {
      here.row(i).setZero();
      continue;
    }
    cageFromPositions_ += here.row(i).transpose() * (there.row(i) / told);
  }
}

Eigen::Matrix3d ParticleFit::worldFromBody(const Eigen::Matrix3Xd& positions) const {
  return positions.lazyProduct(mapFromPositions_);
}

body::Cage ParticleFit::cageOf(const Eigen::Matrix3Xd& positions) const {
  return positions.lazyProduct(cageFromPositions_);
}

}  // namespace rotatebook::physics
