#include "physics/many_springs.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace rotatebook::physics {

double squaredNormOf(const PointList& list) {
  double sum = 0;
  for (const Eigen::Vector3d& point : list.points) sum += point.squaredNorm();
  return sum;
}

PointList plus(const PointList& list, double factor, const PointList& others) {
  PointList result = list;
  for (std::size_t i = 0; i < result.points.size(); ++i)
    result.points[i] += factor * others.points[i];
  return result;
}

void scale(PointList& list, double factor) {
  for (Eigen::Vector3d& point : list.points) point *= factor;
}

void subtractMean(PointList& list) {
  centre(list.points);
}

ManySprings::ManySprings(const PointList& positions, const std::vector<Spring>& springs,
                         double stiffness, double damping)
    : stiffness_(stiffness), damping_(damping) {
  springs_.reserve(springs.size());
  for (const Spring& ends : springs) springs_.push_back({ends, Eigen::Vector3d::Zero(), 0, 0});
  moveTo(positions);
  for (Stretched& spring : springs_) spring.restLength = spring.length;
  moveTo(positions);  // With these lengths
}

void ManySprings::moveTo(const PointList& positions) {
  for (Stretched& spring : springs_) {
    const Eigen::Vector3d arm = positions.points[spring.ends.b] - positions.points[spring.ends.a];
    spring.length = std::sqrt(arm.squaredNorm());
    spring.direction = arm * (1 / spring.length);
  }
  if (damping_ == 0) {
    undamped_ = sumOfPulls(positions.points.size(), [this](const Stretched& spring) {
      return stiffness_ * (spring.length - spring.restLength);
    });
  }
}

PointList ManySprings::forces(const PointList& velocities) const {
  if (damping_ == 0) return undamped_;
  return sumOfPulls(velocities.points.size(), [&](const Stretched& spring) {
    const auto [a, b] = spring.ends;
    const double rate = spring.direction.dot(velocities.points[b] - velocities.points[a]);
    return stiffness_ * (spring.length - spring.restLength) + damping_ * rate;
  });
}

template <typename Tension>
PointList ManySprings::sumOfPulls(std::size_t count, const Tension& tensionOf) const {
  PointList sums{std::vector<Eigen::Vector3d>(count, Eigen::Vector3d::Zero())};
  std::uint32_t first = 0;
  Eigen::Vector3d ofFirst = Eigen::Vector3d::Zero();
  for (const Stretched& spring : springs_) {
    // Many springs in a row begin at the same particle, whose sum is kept at hand.
    if (spring.ends.a != first) {
      sums.points[first] = ofFirst;
      first = spring.ends.a;
      ofFirst = sums.points[first];
    }
    const Eigen::Vector3d pull = tensionOf(spring) * spring.direction;
    ofFirst += pull;
    sums.points[spring.ends.b] -= pull;
  }
  if (!springs_.empty()) sums.points[first] = ofFirst;
  return sums;
}

double ManySprings::energy() const {
  double sum = 0;
  for (const Stretched& spring : springs_) {
    const double stretch = spring.length - spring.restLength;
    sum += stretch * stretch;
  }
  return stiffness_ / 2 * sum;
}

}  // namespace rotatebook::physics
