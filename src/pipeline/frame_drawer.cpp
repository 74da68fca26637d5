#include "pipeline/frame_drawer.h"

#include "pipeline/textures.h"

namespace rotatebook::pipeline {
namespace {

std::optional<overlay::Overlays> makeOverlays(const scene::Scene& scene) {
  if (scene.overlay.show.empty()) return std::nullopt;
  return overlay::Overlays(scene);
}

}  // namespace

FrameDrawer::FrameDrawer(const scene::Scene& scene, const ClipMotion& motion)
    : motion_(&motion),
      overlays_(makeOverlays(scene)),
      renderer_(makeRenderer(scene, overlays_ ? overlays_->bottomRows() : 0)) {}

void FrameDrawer::draw(std::int64_t frame, image::Image& picture) {
  const auto& samples = motion_->trajectories().front().samples;
  renderer_.draw(samples[motion_->sampleAt(0, frame)].corners, picture);
  if (overlays_) overlays_->draw(motion_->clockFrame(frame), picture);
}

}  // namespace rotatebook::pipeline
