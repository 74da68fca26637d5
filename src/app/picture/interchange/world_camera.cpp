#include "picture/interchange/world_camera.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace rotatebook::interchange {

using Eigen::Matrix3d;

WorldCamera::WorldCamera(const scene::Scene& scene, std::vector<double> distances)
    : path_(scene, {scene.clip.width, scene.clip.height, 0}),
      frame_(scene::referenceFramesOf(scene).front()),
      distances_(std::move(distances)),
      aspect_(static_cast<double>(scene.clip.width) / scene.clip.height) {}

bool WorldCamera::moves() const {
  return path_.moves() || frame_.kind() != scene::ReferenceFrame::World ||
         std::ranges::any_of(distances_, [&](double d) { return d != distances_.front(); });
}

double WorldCamera::fieldOfView() const {
  return at(0).fieldOfViewDeg * std::numbers::pi / 180;
}

double WorldCamera::near() const {
  constexpr double kNear = 0.01;  // Share of the distance to the target.
  const geometry::Camera first = at(0);
  return kNear * (first.position - first.target).norm();
}

geometry::Camera WorldCamera::at(std::int64_t frame) const {
  return geometry::movedAway(path_.at(frame), distances_.at(static_cast<std::size_t>(frame)));
}

CameraPlace WorldCamera::placeAt(std::int64_t frame, const physics::Sample& sample) const {
  const geometry::Camera camera = at(frame);
  const Matrix3d worldFromFrame = frame_.fromWorld(sample).transpose();
  const Matrix3d viewFromFrame = geometry::viewFromWorld(camera).topLeftCorner<3, 3>();
  return {worldFromFrame * camera.position,
          Eigen::Quaterniond(Matrix3d(worldFromFrame * viewFromFrame.transpose()))};
}

}  // namespace rotatebook::interchange
