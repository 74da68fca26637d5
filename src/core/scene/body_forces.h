// The forces on a motion's body in the frame of reference of its pictures.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace rotatebook::scene {

/// Forces above so many times the start's don't shorten the arrows of all others.
inline constexpr double kLargestForce = 4;

/// The body of a motion as point masses that have its mass and its moments together, and the forces
/// on each: the weights of a shape that has some; else eight equal ones, see
/// physics::equimomentalPlaces(), which are the paper's particles where the model has those.
class BodyForces {
 public:
  BodyForces(const Motion& motion, const MotionFrame& frame);

  const std::vector<Eigen::Vector3d>& places() const { return places_; }  ///< In body axes. [m]
  /// Returns the forces on each mass, of a body that isn't rigid as if it were at this moment;
  /// `seen` is a sample in the frame.
  std::vector<rigid::ForcesPerMass> at(const physics::Sample& seen) const;
  /// Returns the largest of them; `sample` is in the world. [N/kg]
  double largestAt(const physics::Sample& sample) const;

 private:
  MotionFrame frame_;
  std::vector<Eigen::Vector3d> places_;
  rigid::PrincipalAxes inertia_;
  double dissipation_;  // [kg m^2 s]
};

}  // namespace rotatebook::scene
