#include "rigid/poinsot.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace rotatebook::rigid {
namespace {

Eigen::Vector3d ascending(Eigen::Vector3d numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// Returns the radius at which the contact point crosses the plane of two semi-axes, one of them
/// shorter than the distance, one longer.
double radiusBetween(double shorter, double longer, double distance) {
  const double inside = (distance - shorter) * (distance + shorter);
  const double outside = (longer - distance) * (longer + distance);
  return std::sqrt(std::max(0.0, inside) * std::max(0.0, outside)) / distance;
}

}  // namespace

Poinsot poinsotOf(const Eigen::Vector3d& moments, const Eigen::Vector3d& momentum) {
  const Eigen::Vector3d velocity = momentum.cwiseQuotient(moments);
  const double root = std::sqrt(velocity.dot(momentum));
  return {velocity / root, root / momentum.norm()};
}

Eigen::Vector3d inertiaSemiAxes(const Eigen::Vector3d& moments) {
  return moments.cwiseSqrt().cwiseInverse();
}

HerpolhodeRadii herpolhodeRadii(const Eigen::Vector3d& semiAxes, double distance) {
  const Eigen::Vector3d axes = ascending(semiAxes);
  const double d = std::clamp(distance, axes[0], axes[2]);
  const double least =
      d < axes[1] ? radiusBetween(axes[0], axes[1], d) : radiusBetween(axes[1], axes[2], d);
  return {least, radiusBetween(axes[0], axes[2], d)};
}

Eigen::Vector3d axisEnergies(const Eigen::Vector3d& moments, double momentum) {
  return momentum * momentum / 2 * moments.cwiseInverse();
}

double reachOfMomentum(const Eigen::Vector3d& energies, double energy) {
  const Eigen::Vector3d e = ascending(energies);
  const double end = energy < e[1] ? e[0] : e[2];
  const double share = (energy - end) / (e[1] - end);
  if (!(share > 0)) return 0;
  return arcTangent(std::sqrt(share), std::sqrt(std::max(0.0, 1 - share)));
}

}  // namespace rotatebook::rigid
