#include "study/map_point.h"

#include <array>
#include <numbers>

#include "base/elementary.h"
#include "base/error.h"
#include "base/number_text.h"
#include "physics/motion_start.h"
#include "rigid/regime.h"

namespace rotatebook::study {
namespace {

using physics::MotionSettings;
using scene::AxisKind;

/// The values that axes have at a point.
struct Values {
  std::array<AxisKind, 2> kinds;
  std::array<double, 2> numbers;

  std::optional<double> of(AxisKind kind) const {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      if (kinds[i] == kind) return numbers[i];
    }
    return std::nullopt;
  }
};

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

/// Turns the spin of a motion into another direction, of the same length.
void turnSpin(const Values& values, MotionSettings& motion) {
  const auto longitude = values.of(AxisKind::SpinLongitude);
  const auto latitude = values.of(AxisKind::SpinLatitude);
  if (!longitude && !latitude) return;
  const Eigen::Vector3d spin = motion.initial.value;
  const double length = spin.norm();
  const double along = longitude ? radians(*longitude) : arcTangent(spin.y(), spin.x());
  const double up =
      latitude ? radians(*latitude) : arcTangent(spin.z(), roundedHypotenuse(spin.x(), spin.y()));
  const CosineSine east = cosineSine(along), north = cosineSine(up);
  motion.initial.value =
      length * Eigen::Vector3d(north.cosine * east.cosine, north.cosine * east.sine, north.sine);
}

/// Gives a body other ratios of its moments of inertia. Its largest moment stays, and each axis
/// keeps its rank. Throws InputError unless the first is the smallest.
void changeMoments(const Values& values, MotionSettings& motion) {
  const auto smallest = values.of(AxisKind::SmallestMoment);
  const auto middle = values.of(AxisKind::MiddleMoment);
  if (!smallest && !middle) return;
  const rigid::PrincipalAxes old = modelInertia(motion);
  const auto axes = rigid::axesByInertia(old.moments);
  Eigen::Vector3d moments = old.moments;
  const double largest = moments[axes[2]];
  if (smallest) moments[axes[0]] = *smallest * largest;
  if (middle) moments[axes[1]] = *middle * largest;
  if (moments[axes[0]] > moments[axes[1]]) {
    throw InputError("the smallest moment of inertia, " + shortestText(moments[axes[0]]) +
                     ", is larger than the middle one, " + shortestText(moments[axes[1]]));
  }
  const Eigen::Matrix3d& map = old.bodyFromPrincipal;
  const Eigen::Matrix3d tensor = map * moments.asDiagonal() * map.transpose();
  takeInertia(motion, (tensor + tensor.transpose()) / 2);
}

}  // namespace

MapPoints::MapPoints(const MotionSettings& base, const scene::MapSettings& map)
    : base_(base), x_(axisOf(map.x, base)), y_(axisOf(map.y, base)) {}

MapPoints::Axis MapPoints::axisOf(const scene::Axis& axis, const MotionSettings& base) {
  if (axis.kind != AxisKind::MotionKey) return {axis.kind, std::nullopt};
  return {axis.kind, scene::MotionNumber(base, axis.key, axis.to, axis.key)};
}

MotionSettings MapPoints::at(double x, double y) const {
  MotionSettings motion = base_;
  if (x_.number) x_.number->set(motion, x);
  if (y_.number) y_.number->set(motion, y);
  const Values values{{x_.kind, y_.kind}, {x, y}};
  turnSpin(values, motion);
  changeMoments(values, motion);
  return motion;
}

}  // namespace rotatebook::study
