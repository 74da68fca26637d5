#include "pipeline/frame_drawer.h"

#include <cstddef>

#include "pipeline/textures.h"

namespace rotatebook::pipeline {
namespace {

std::optional<overlay::Overlays> makeOverlays(const scene::Scene& scene) {
  if (scene.overlay.show.empty()) return std::nullopt;
  return overlay::Overlays(scene);
}

}  // namespace

FrameDrawer::FrameDrawer(const scene::Scene& scene, const physics::Trajectory& trajectory)
    : trajectory_(&trajectory),
      overlays_(makeOverlays(scene)),
      renderer_(makeRenderer(scene, overlays_ ? overlays_->bottomRows() : 0)) {}

void FrameDrawer::draw(std::int64_t frame, image::Image& picture) {
  renderer_.draw(trajectory_->samples[static_cast<std::size_t>(frame)].corners, picture);
  if (overlays_) overlays_->draw(frame, picture);
}

}  // namespace rotatebook::pipeline
