#include "bridge/played_scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "base/elementary.h"
#include "base/error.h"
#include "scene/scene_text.h"
#include "timeline/scene_camera.h"

namespace rotatebook::bridge {
namespace {

using Eigen::Vector3d;

/// Returns `vector` turned by `angle` about the unit vector `axis`. (Rodrigues)
Vector3d turned(const Vector3d& vector, const Vector3d& axis, double angle) {
  return cosine(angle) * vector + sine(angle) * axis.cross(vector) +
         (1 - cosine(angle)) * axis.dot(vector) * axis;
}

void refuseLong(const scene::Scene& scene, std::size_t motions, std::int64_t maxFrames) {
  const std::int64_t frames = scene.clip.frameCount();
  if (frames <= maxFrames / static_cast<std::int64_t>(motions)) return;
  const bool isOne = motions == 1;
  throw InputError(scene.name +
                   ".toml: the motion is too long to be played here: " + std::to_string(frames) +
                   " frames" + (isOne ? "" : " of each of " + std::to_string(motions) + " books") +
                   ", at most " + std::to_string(maxFrames) + (isOne ? "" : " together") +
                   "; rotatebook render makes its clip");
}

}  // namespace

PlayedScene::PlayedScene(scene::Scene scene, std::int64_t maxFrames)
    : scene_(std::move(scene)),
      motionCount_(scene_.motions.size()),
      frames_(scene::referenceFramesOf(scene_)) {
  refuseLong(scene_, motionCount_, maxFrames);
  simulation_.emplace(scene_);
}

bool PlayedScene::hasMotionsOf(const scene::Scene& scene) const {
  return !failure_ && motionText(scene_) == motionText(scene);
}

void PlayedScene::replace(scene::Scene scene) {
  scene_ = std::move(scene);
  frames_ = scene::referenceFramesOf(scene_);
  if (simulation_) simulation_->takeNames(scene_);
  if (whole_) distances_.emplace(scene_, *whole_);
}

std::int64_t PlayedScene::stepsOfFrame() const {
  constexpr double kManySteps = 1e15;
  double steps = 0;
  for (const scene::Panel& panel : scene_.motions) {
    const physics::EqualSteps each = panel.simulation.steps();
    steps += each.count * std::max(1.0, std::ceil(panel.simulation.timePerFrame / each.time));
  }
  return static_cast<std::int64_t>(std::min(steps, kManySteps));
}

void PlayedScene::simulate(std::int64_t frame, std::int64_t steps) {
  const std::int64_t each = stepsOfFrame();
  while (simulation_->frames() <= frame && !simulation_->isComplete()) {
    simulation_->advance();
    steps -= each;
    if (steps <= 0) break;
  }
}

std::int64_t PlayedScene::advance(std::int64_t frame, std::int64_t steps) {
  if (failure_) std::rethrow_exception(failure_);
  if (whole_) return whole_->frameCount();
  try {
    simulate(frame, steps);
  } catch (...) {
    failure_ = std::current_exception();
    throw;
  }
  if (!simulation_->isComplete()) return simulation_->frames();
  whole_ = simulation_->motion();
  simulation_.reset();
  distances_.emplace(scene_, *whole_);
  return whole_->frameCount();
}

std::int64_t PlayedScene::frameCount() const {
  return whole_ ? whole_->frameCount() : scene_.clip.frameCount();
}

const physics::Trajectory& PlayedScene::trajectory(std::size_t motion) const {
  if (motion >= motionCount_) throw std::out_of_range("there is no such motion");
  return whole_ ? whole_->trajectories()[motion] : simulation_->trajectory(motion);
}

const std::vector<physics::Sample>& PlayedScene::samples(std::size_t motion) const {
  return trajectory(motion).samples;
}

std::size_t PlayedScene::indexOf(std::size_t motion, std::int64_t frame) const {
  const auto last = static_cast<std::int64_t>(samples(motion).size()) - 1;
  return static_cast<std::size_t>(std::clamp<std::int64_t>(frame, 0, last));
}

physics::Sample PlayedScene::sample(std::size_t motion, std::int64_t frame) const {
  return frames_[motion].seen(samples(motion)[indexOf(motion, frame)]);
}

bool PlayedScene::turns() const {
  const auto isTurning = [](const scene::MotionFrame& frame) {
    return frame.kind() == scene::ReferenceFrame::Turning;
  };
  return std::ranges::any_of(frames_, isTurning) ||
         std::ranges::any_of(scene_.cues,
                             [](const scene::Cue& cue) { return cue.move.has_value(); });
}

bool PlayedScene::isHeld(std::size_t motion, std::int64_t frame) const {
  const physics::Trajectory& held = trajectory(motion);
  return held.divergedAt && frame >= static_cast<std::int64_t>(held.samples.size());
}

geometry::Camera PlayedScene::camera(std::size_t motion, std::int64_t frame,
                                     const geometry::Screen& screen, const Orbit& orbit) const {
  if (motion >= motionCount_) throw std::out_of_range("there is no such motion");
  geometry::Camera camera = timeline::CameraPath(scene_, screen).at(frame);
  if (distances_) {
    const auto nearest = std::clamp<std::int64_t>(frame, 0, whole_->frameCount() - 1);
    camera = geometry::movedAway(camera, distances_->at(motion, nearest));
  } else {
    camera = geometry::movedAway(camera, timeline::distanceAtRest(scene_, motion));
  }
  if (orbit.right != 0 || orbit.up != 0) {
    const Vector3d up = camera.up.normalized();
    const Vector3d arm = turned(camera.position - camera.target, up, -orbit.right);
    const Vector3d right = up.cross(arm).normalized();
    camera.position = camera.target + turned(arm, right, -orbit.up);
    camera.up = turned(up, right, -orbit.up);
  }
  return geometry::movedAway(camera, orbit.distance);
}

}  // namespace rotatebook::bridge
