#include "physics/measure/flip_interval.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include "base/elementary.h"
#include "rigid/regime.h"

namespace rotatebook::physics {
namespace {

// eps / sin(eps), where eps is the angle between `w` and the line of axis `middle`.
double angleBySine(const Eigen::Vector3d& w, int middle) {
  const double along = std::fabs(w[middle]);
  const double across = roundedHypotenuse(w[(middle + 1) % 3], w[(middle + 2) % 3]);
  return across == 0 ? 1 : arcTangent(across, along) * w.norm() / across;
}

}  // namespace

std::vector<double> flipTimes(const Trajectory& trajectory, const rigid::PrincipalAxes& inertia) {
  requireSameLayout();
  const Eigen::Vector3d axis = middleAxis(inertia);
  const auto rateOf = [&axis](const Sample& sample) {
    return spinAbout(axis, sample.attitude, sample.angularVelocity);
  };
  std::vector<double> times;
  const std::vector<Sample>& samples = trajectory.samples;
  double before = rateOf(samples.front());
  for (std::size_t n = 1; n < samples.size(); ++n) {
    const double rate = rateOf(samples[n]);
    const auto flip = flipBetween(samples[n - 1].time, trajectory.interval, before, rate);
    if (flip) times.push_back(*flip);
    before = rate;
  }
  return times;
}

double spinAbout(const Eigen::Vector3d& axis, const Eigen::Quaterniond& attitude,
                 const Eigen::Vector3d& angularVelocity) {
  return (attitude * axis).dot(angularVelocity);
}

std::optional<double> flipBetween(double time, double interval, double before, double after) {
  if ((before < 0) == (after < 0)) return std::nullopt;
  return time + interval * before / (before - after);
}

double meanInterval(std::span<const double> times) {
  if (times.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

double tiltGrowth(const rigid::PrincipalAxes& inertia) {
  const auto axes = rigid::axesByInertia(inertia.moments);
  const double i1 = inertia.moments[axes[0]];
  const double i2 = inertia.moments[axes[1]];
  const double i3 = inertia.moments[axes[2]];
  return std::sqrt((i2 - i1) * (i3 - i2) / (i1 * i3));
}

double asymptoticFlipInterval(const rigid::PrincipalAxes& inertia,
                              const Eigen::Vector3d& angularVelocity) {
  const auto axes = rigid::axesByInertia(inertia.moments);
  const double i1 = inertia.moments[axes[0]];
  const double i2 = inertia.moments[axes[1]];
  const double i3 = inertia.moments[axes[2]];
  if (!(i1 < i2 && i2 < i3)) return std::numeric_limits<double>::infinity();
  const Eigen::Vector3d w = inertia.bodyFromPrincipal.transpose() * angularVelocity;
  const double spin = w.norm();
  const double growth = spin * tiltGrowth(inertia);
  const double distance =
      std::fabs(rigid::middleInvariantRoot({i1, i2, i3}, w[axes[0]], w[axes[2]]).value());
  const double modulus = distance / spin * std::sqrt((i3 - i1) / (i2 * (i2 - i1) * (i3 - i2)));
  return 2 / growth * logarithm(4 / (modulus * angleBySine(w, axes[1])));
}

Eigen::Vector3d middleAxis(const rigid::PrincipalAxes& inertia) {
  return inertia.bodyFromPrincipal.col(rigid::axesByInertia(inertia.moments)[1]);
}

}  // namespace rotatebook::physics
