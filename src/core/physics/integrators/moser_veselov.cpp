#include "physics/integrators/moser_veselov.h"

namespace rotatebook::physics {
namespace {

// The preprocessed inertia J: 1/J = scale/I + shift.
struct Correction {
  double scale = 1;
  double shift = 0;
};

Correction correctionOf(const RigidConstants& body, double h, int order) {
  if (order < 4) return {};
  const Eigen::Vector3d& inertia = body.inertia;
  const Eigen::Vector3d& inverse = body.inverseInertia;
  const double c = h * h * body.momentum.squaredNorm() / 2;
  const double e = h * h * body.momentum.dot(inverse.cwiseProduct(body.momentum)) / 2;
  const double d = inertia.prod();
  const double s1 = inertia.sum(), x1 = inverse.sum();
  Correction result{1 + s1 * c / (6 * d) - x1 * e / 3, -c / (3 * d) + s1 * e / (6 * d)};
  if (order < 6) return result;

  const double s2 = inertia.squaredNorm(), x2 = inverse.squaredNorm();
  // Sum of (I1+I2)/I3 and its cyclic permutations.
  const double xs = s1 * x1 - 3;
  result.scale += (s2 / d - x1) / (30 * d) * c * c + (1 - xs) / (30 * d) * c * e +
                  (3 * s1 / d + 2 * x2) / 60 * e * e;
  result.shift += -s1 / (60 * d * d) * c * c + (x1 / (10 * d) - s2 / (60 * d * d)) * c * e -
                  (9 + xs) / (60 * d) * e * e;
  return result;
}

}  // namespace

Eigen::Vector3d preprocessedInertia(const RigidConstants& body, double h, int order) {
  const auto [scale, shift] = correctionOf(body, h, order);
  return (scale * body.inverseInertia.array() + shift).inverse().matrix();
}

}  // namespace rotatebook::physics
