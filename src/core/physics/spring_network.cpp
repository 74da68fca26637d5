#include "physics/spring_network.h"

#include <cmath>

namespace rotatebook::physics {
namespace {

// The points that two springs join: q and q + 4 (the lanes of element `q`) with r and r + 4 or, if
// crossed, with r + 4 and r.
struct Joint {
  std::size_t q, r;
  bool crossed;
};

constexpr std::size_t kDoublyCounted = 12;  // From here on q = r, and both lanes hold one spring.

constexpr std::array<Joint, 16> kJoints{{{0, 1, false},
                                         {0, 2, false},
                                         {0, 3, false},
                                         {1, 2, false},
                                         {1, 3, false},
                                         {2, 3, false},
                                         {0, 1, true},
                                         {0, 2, true},
                                         {0, 3, true},
                                         {1, 2, true},
                                         {1, 3, true},
                                         {2, 3, true},
                                         {0, 0, true},
                                         {1, 1, true},
                                         {2, 2, true},
                                         {3, 3, true}}};

inline DoublePair crossedIf(bool crossed, DoublePair lanes) {
  return crossed ? DoublePair{lanes[1], lanes[0]} : lanes;
}

// Returns partner minus point.
inline DoublePair difference(const EightDoubles& components, const Joint& joint) {
  return crossedIf(joint.crossed, components[joint.r]) - components[joint.q];
}

inline std::array<DoublePair, 3> difference(const Points& points, const Joint& joint) {
  return {difference(points[0], joint), difference(points[1], joint), difference(points[2], joint)};
}

inline DoublePair dot(const std::array<DoublePair, 3>& a, const std::array<DoublePair, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline DoublePair rootOf(DoublePair lanes) {
  return DoublePair{std::sqrt(lanes[0]), std::sqrt(lanes[1])};
}

}  // namespace

double sumOf(const EightDoubles& numbers) {
  const DoublePair sum = (numbers[0] + numbers[1]) + (numbers[2] + numbers[3]);
  return sum[0] + sum[1];
}

double squaredNormOf(const Points& points) {
  EightDoubles squares;
  for (std::size_t q = 0; q < 4; ++q) {
    const std::array<DoublePair, 3> point{points[0][q], points[1][q], points[2][q]};
    squares[q] = dot(point, point);
  }
  return sumOf(squares);
}

Points plus(const Points& points, double factor, const Points& others) {
  Points result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t q = 0; q < 4; ++q) {
      result[axis][q] = points[axis][q] + factor * others[axis][q];
    }
  }
  return result;
}

void scale(Points& points, double factor) {
  for (EightDoubles& components : points) {
    for (DoublePair& lanes : components) lanes *= factor;
  }
}

void subtractMean(Points& points) {
  constexpr double kCount = 8;
  for (EightDoubles& components : points) {
    const double mean = sumOf(components) / kCount;
    for (DoublePair& lanes : components) lanes -= mean;
  }
}

SpringNetwork::SpringNetwork(const Points& positions, double stiffness, double damping)
    : stiffness_(stiffness), damping_(damping) {
  moveTo(positions);
  for (Springs& springs : springs_) springs.restLengths = springs.lengths;
}

void SpringNetwork::moveTo(const Points& positions) {
#pragma GCC unroll 16
  for (std::size_t n = 0; n < kCount; ++n) {
    const std::array<DoublePair, 3> arm = difference(positions, kJoints[n]);
    const DoublePair length = rootOf(dot(arm, arm));
    const DoublePair inverse = 1 / length;
    springs_[n].lengths = length;
    springs_[n].directions = {arm[0] * inverse, arm[1] * inverse, arm[2] * inverse};
  }
}

Points SpringNetwork::forces(const Points& velocities) const {
  Points sums{};
#pragma GCC unroll 16
  for (std::size_t n = 0; n < kCount; ++n) {
    const Joint& joint = kJoints[n];
    const Springs& springs = springs_[n];
    const DoublePair rate = dot(springs.directions, difference(velocities, joint));
    const DoublePair tension =
        stiffness_ * (springs.lengths - springs.restLengths) + damping_ * rate;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const DoublePair pull = tension * springs.directions[axis];
      sums[axis][joint.q] += pull;
      if (n < kDoublyCounted) sums[axis][joint.r] -= crossedIf(joint.crossed, pull);
    }
  }
  return sums;
}

double SpringNetwork::energy() const {
  DoublePair once{}, twice{};
  for (std::size_t n = 0; n < kCount; ++n) {
    const DoublePair stretch = springs_[n].lengths - springs_[n].restLengths;
    (n < kDoublyCounted ? once : twice) += stretch * stretch;
  }
  const DoublePair sum = once + twice / 2;
  return stiffness_ / 2 * (sum[0] + sum[1]);
}

}  // namespace rotatebook::physics
