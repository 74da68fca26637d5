#include "bridge/why_numbers.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <Eigen/Geometry>

#include "base/json.h"
#include "bridge/bridge.h"
#include "physics/free_motion.h"
#include "physics/motion_start.h"
#include "rigid/energy_ladder.h"
#include "rigid/poinsot.h"
#include "timeline/spin.h"

namespace rotatebook::bridge {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kDegrees = 180 / std::numbers::pi;

template <typename Values>
void append(std::vector<double>& numbers, const Values& values) {
  numbers.insert(numbers.end(), values.data(), values.data() + values.size());
}

/// Returns the linear map from the body to its cage: the best one, by least squares.
Matrix3d mapOf(const body::Cuboid& body, const body::Cage& cage) {
  const body::Cage rest = body.corners();
  const Vector3d squares = rest.rowwise().squaredNorm();
  return (cage.colwise() - cage.rowwise().mean()) * rest.transpose() *
         squares.cwiseInverse().asDiagonal();
}

}  // namespace

PlayedForces::PlayedForces(const PlayedScene& played, std::size_t motion)
    : motion_(motion),
      forces_(played.scene().motions.at(motion), played.frameOf(motion)),
      limit_(scene::kLargestForce * forces_.largestAt(played.samples(motion).front())) {}

std::vector<double> PlayedForces::at(const PlayedScene& played, std::int64_t frame) {
  const std::vector<physics::Sample>& samples = played.samples(motion_);
  for (; seen_ < samples.size(); ++seen_)
    largest_ = std::max(largest_, forces_.largestAt(samples[seen_]));
  std::vector<double> numbers{std::min(largest_, limit_)};
  const physics::Sample sample = played.sample(motion_, frame);
  const Matrix3d map = mapOf(played.scene().motions[motion_].body, sample.cage);
  const Vector3d centre = sample.cage.rowwise().mean();
  const std::vector<rigid::ForcesPerMass> forces = forces_.at(sample);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    append(numbers, Vector3d(centre + map * forces_.places()[i]));
    append(numbers, forces[i].held);
    append(numbers, forces[i].centrifugal);
    append(numbers, forces[i].coriolis);
    append(numbers, forces[i].euler);
  }
  return numbers;
}

std::vector<double> ladderNumbers(const PlayedScene& played, std::size_t motion,
                                  std::int64_t frame) {
  const auto inertia = physics::modelInertia(played.scene().motions.at(motion));
  const rigid::EnergyLadder ladder(inertia.moments);
  const physics::Sample& sample = played.samples(motion)[played.indexOf(motion, frame)];
  const Vector3d momentum = physics::momentumAlong(inertia, sample);
  const double energy = sample.total() / momentum.squaredNorm();
  const rigid::LadderPlace now = ladder.placeOf(momentum, energy);
  std::vector<double> numbers{now.height, ladder.reachAt(energy) / std::numbers::pi,
                              now.angle / std::numbers::pi, 100 * ladder.aboveMiddle(energy)};
  for (const int axis : ladder.axes()) {
    const bool isTurned = !inertia.bodyFromPrincipal.isIdentity(1e-9);
    const double spin = ladder.energyOf(axis);
    numbers.insert(numbers.end(), {static_cast<double>(axis), isTurned ? 1.0 : 0.0,
                                   ladder.heightOf(spin), ladder.reachAt(spin) / std::numbers::pi});
  }
  for (const rigid::LadderPlace& place : ladder.outline())
    numbers.insert(numbers.end(), {place.height, place.angle / std::numbers::pi});
  return numbers;
}

std::vector<double> poinsotNumbers(const PlayedScene& played, std::size_t motion,
                                   std::int64_t frame, std::int64_t trail) {
  const scene::Panel& panel = played.scene().motions.at(motion);
  const auto inertia = physics::modelInertia(panel);
  Vector3d semiAxes = rigid::inertiaSemiAxes(inertia.moments);
  const double scale = panel.body.largestDimension() / 2 / semiAxes.maxCoeff();
  semiAxes *= scale;
  const auto contactOf = [&](const physics::Sample& sample) -> Vector3d {
    const auto poinsot = rigid::poinsotOf(inertia.moments, physics::momentumAlong(inertia, sample));
    return scale * (inertia.bodyFromPrincipal * poinsot.contact);
  };

  const std::vector<physics::Sample>& samples = played.samples(motion);
  const std::size_t index = played.indexOf(motion, frame);
  const physics::Sample& sample = samples[index];
  const Matrix3d frameFromWorld = played.frameOf(motion).fromWorld(sample);
  const Matrix3d frameFromBody = frameFromWorld * sample.attitude.toRotationMatrix();
  const Vector3d centre = frameFromWorld * sample.cage.rowwise().mean();
  const double distance =
      scale * rigid::poinsotOf(inertia.moments, physics::momentumAlong(inertia, sample)).distance;
  if (!std::isfinite(distance)) return {};
  const auto radii = rigid::herpolhodeRadii(semiAxes, distance);
  const Vector3d normal = sample.angularMomentum.normalized(), across = normal.unitOrthogonal();

  std::vector<double> numbers{distance, radii.least, radii.greatest, semiAxes.maxCoeff()};
  append(numbers, centre);
  append(numbers, Matrix3d(frameFromBody * inertia.bodyFromPrincipal * semiAxes.asDiagonal()));
  append(numbers, Vector3d(frameFromWorld * across));
  append(numbers, Vector3d(frameFromWorld * normal.cross(across)));
  append(numbers, Vector3d(frameFromWorld * normal));
  const std::vector<std::size_t> starts = physics::freeStarts(samples, panel.nudges);
  const std::size_t since = *std::prev(std::upper_bound(starts.begin(), starts.end(), index));
  const auto length = static_cast<std::size_t>(std::clamp<std::int64_t>(trail, 0, kMaxTrail));
  for (std::size_t i = std::max(since, index - std::min(index, length)); i <= index; ++i) {
    const Vector3d contact = contactOf(samples[i]);
    if (!contact.allFinite()) continue;
    append(numbers, Vector3d(centre + frameFromBody * contact));
    append(numbers, Vector3d(centre + frameFromWorld * (samples[i].attitude * contact)));
  }
  return numbers;
}

Json spinJson(const scene::Motion& motion) {
  const timeline::Spin spin = timeline::spinOf(motion);
  const std::array<const char*, 3> moments{"smallest", "middle", "largest"};
  return {{"speed", spin.angularVelocity.norm()},
          {"axis", moments[spin.spunAxis]},
          {"offAxis", spin.offAxis * kDegrees},
          {"circled", moments[spin.circledAxis()]},
          {"isSteady", spin.isSteady},
          {"hasEqualMoments", spin.equal != timeline::EqualMoments::None},
          {"flipInterval", orNull(spin.flipInterval())},
          {"firstFlip", orNull(spin.firstFlip)}};
}

}  // namespace rotatebook::bridge
