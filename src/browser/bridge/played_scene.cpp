#include "bridge/played_scene.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "base/elementary.h"
#include "scene/reference_frame.h"
#include "timeline/scene_camera.h"

namespace rotatebook::bridge {
namespace {

using Eigen::Vector3d;

/// Returns `vector` turned by `angle` about the unit vector `axis`. (Rodrigues)
Vector3d turned(const Vector3d& vector, const Vector3d& axis, double angle) {
  return cosine(angle) * vector + sine(angle) * axis.cross(vector) +
         (1 - cosine(angle)) * axis.dot(vector) * axis;
}

}  // namespace

PlayedScene::PlayedScene(scene::Scene scene) : scene_(std::move(scene)), simulation_(scene_) {}

std::int64_t PlayedScene::stepsOfFrame() const {
  std::int64_t steps = 0;
  for (const scene::Panel& panel : scene::motionsOf(scene_)) steps += panel.simulation.substeps;
  return steps;
}

std::int64_t PlayedScene::advance(std::int64_t frame, std::int64_t steps) {
  const std::int64_t each = stepsOfFrame();
  while (simulation_.frames() <= frame && !simulation_.isComplete()) {
    simulation_.advance();
    steps -= each;
    if (steps <= 0) break;
  }
  if (simulation_.isComplete() && !whole_) {
    whole_ = simulation_.motion();
    distances_.emplace(scene_, *whole_);
  }
  return whole_ ? whole_->frameCount() : simulation_.frames();
}

std::int64_t PlayedScene::frameCount() const {
  return whole_ ? whole_->frameCount() : scene_.clip.frameCount();
}

physics::Sample PlayedScene::sample(std::size_t motion, std::int64_t frame) const {
  const auto& samples = simulation_.trajectory(motion).samples;
  const auto last = static_cast<std::int64_t>(samples.size()) - 1;
  const auto index = static_cast<std::size_t>(std::clamp<std::int64_t>(frame, 0, last));
  return scene::inReferenceFrame(scene_.camera.frame, samples[index]);
}

bool PlayedScene::isHeld(std::size_t motion, std::int64_t frame) const {
  const physics::Trajectory& trajectory = simulation_.trajectory(motion);
  return trajectory.divergedAt && frame >= static_cast<std::int64_t>(trajectory.samples.size());
}

geometry::Camera PlayedScene::camera(std::size_t motion, std::int64_t frame,
                                     const geometry::Screen& screen, const Orbit& orbit) const {
  geometry::Camera camera = timeline::cameraOf(scene_, screen);
  if (distances_) camera = geometry::movedAway(camera, distances_->at(motion, frame));
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
