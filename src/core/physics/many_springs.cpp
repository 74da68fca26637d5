#include "physics/many_springs.h"

#include <cmath>
#include <cstddef>

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
}

void ManySprings::moveTo(const PointList& positions) {
  for (Stretched& spring : springs_) {
    const Eigen::Vector3d arm = positions.points[spring.ends.b] - positions.points[spring.ends.a];
    spring.length = std::sqrt(arm.squaredNorm());
    spring.direction = arm * (1 / spring.length);
  }
}

PointList ManySprings::forces(const PointList& velocities) const {
  PointList sums{std::vector<Eigen::Vector3d>(velocities.points.size(), Eigen::Vector3d::Zero())};
  for (const Stretched& spring : springs_) {
    const auto [a, b] = spring.ends;
    const double rate = spring.direction.dot(velocities.points[b] - velocities.points[a]);
    const double tension = stiffness_ * (spring.length - spring.restLength) + damping_ * rate;
    const Eigen::Vector3d pull = tension * spring.direction;
    sums.points[a] += pull;
    sums.points[b] -= pull;
  }
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
