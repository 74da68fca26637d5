#include "bridge/why_numbers.h"

#include <algorithm>
#include <numbers>

#include <Eigen/Geometry>

#include "base/json.h"
#include "bridge/bridge.h"
#include "timeline/spin.h"
#include "timeline/why_numbers.h"

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
  return timeline::ladderNumbers(played.scene().motions.at(motion),
                                 played.samples(motion)[played.indexOf(motion, frame)]);
}

std::vector<double> poinsotNumbers(const PlayedScene& played, std::size_t motion,
                                   std::int64_t frame, std::int64_t trail) {
  return timeline::poinsotNumbers(
      played.scene().motions.at(motion), played.samples(motion), played.indexOf(motion, frame),
      played.frameOf(motion),
      static_cast<std::size_t>(std::clamp<std::int64_t>(trail, 0, kMaxTrail)));
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
