// Any number of points, some pairs of which are joined by springs and dampers. Inside the room
// only.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "physics/mass_spring_system.h"

namespace rotatebook::physics {

/// One vector for each particle.
struct PointList {
  std::vector<Eigen::Vector3d> points;
};

// As those of eight particles: sums are added in the order of the particles.
double squaredNormOf(const PointList& list);
PointList plus(const PointList& list, double factor, const PointList& others);
void scale(PointList& list, double factor);
void subtractMean(PointList& list);

/// The springs of a MassSpringSystem, with the interface of SpringNetwork.
class ManySprings {
 public:
  using Points = PointList;

  /// Springs of `stiffness` [N/m], at rest at `positions` [m], with dampers of `damping` [kg/s].
  ManySprings(const PointList& positions, const std::vector<Spring>& springs, double stiffness,
              double damping);

  /// Moves the points to `positions`. [m]
  void moveTo(const PointList& positions);
  /// Returns the force on each point at these velocities [m/s]. [N]
  PointList forces(const PointList& velocities) const;
  /// Returns the energy in the springs. [J]
  double energy() const;

 private:
  struct Stretched {
    Spring ends;
    Eigen::Vector3d direction;  // the unit vector from a to b
    double length, restLength;
  };

  /// Adds up what all springs pull each of `count` points with, in the order of the springs.
  template <typename Tension>
  PointList sumOfPulls(std::size_t count, const Tension& tensionOf) const;

  std::vector<Stretched> springs_;
  PointList undamped_;  // The forces without dampers, which depend on the positions alone.
  double stiffness_;
  double damping_;
};

}  // namespace rotatebook::physics
