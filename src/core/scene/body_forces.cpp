#include "scene/body_forces.h"

#include <algorithm>

#include "body/shape.h"
#include "physics/motion_start.h"
#include "physics/particle_places.h"

namespace rotatebook::scene {
namespace {

/// Returns the places of the weights of the body's shape; none of most bodies.
std::vector<Eigen::Vector3d> weightsOf(const Motion& motion) {
  std::vector<Eigen::Vector3d> places;
  const bool isRigid = motion.simulation.model != physics::Model::Particles;
  if (!isRigid || !motion.solid.isShape) return places;
  const BodyPart& part = motion.solid.parts.front();
  const body::Shape* shape = body::findShape(part.shape);
  if (shape == nullptr || shape->weights == nullptr) return places;
  for (const body::PointMass& weight : shape->weights(part.lengths)) places.push_back(weight.place);
  return places;
}

}  // namespace

BodyForces::BodyForces(const Motion& motion, const MotionFrame& frame)
    : frame_(frame),
      places_(weightsOf(motion)),
      inertia_(physics::modelInertia(motion)),
      dissipation_(motion.simulation.dissipates() ? motion.simulation.dissipation : 0) {
  if (places_.empty()) places_ = physics::equimomentalPlaces(inertia_, motion.body.mass);
}

std::vector<rigid::ForcesPerMass> BodyForces::at(const physics::Sample& seen) const {
  const rigid::Turning body =
      rigid::freeTurning(inertia_, seen.attitude.conjugate() * seen.angularVelocity, dissipation_);
  const rigid::Turning frame = frame_.turningAt(body);
  const Eigen::Matrix3d frameFromBody = seen.attitude.toRotationMatrix();
  std::vector<rigid::ForcesPerMass> forces;
  for (const Eigen::Vector3d& place : places_)
    forces.push_back(rigid::forcesIn(frame, frameFromBody, body, place));
  return forces;
}

double BodyForces::largestAt(const physics::Sample& sample) const {
  double largest = 0;
  for (const rigid::ForcesPerMass& forces : at(frame_.seen(sample))) {
    for (const Eigen::Vector3d* force :
         {&forces.held, &forces.centrifugal, &forces.coriolis, &forces.euler})
      largest = std::max(largest, force->stableNorm());
  }
  return largest;
}

}  // namespace rotatebook::scene
