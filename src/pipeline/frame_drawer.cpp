#include "pipeline/frame_drawer.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "pipeline/textures.h"

namespace rotatebook::pipeline {
namespace {

constexpr int kSmallestPanel = 16;  // The shorter side. [pixels]
constexpr std::array<std::uint8_t, 4> kGroundColour{17, 17, 19, 255};

std::optional<overlay::Overlays> makeOverlays(const scene::Scene& scene) {
  if (scene.overlay.show.empty()) return std::nullopt;
  return overlay::Overlays(scene);
}

/// Panels are above the rows that words take; the picture of a single motion goes on below them.
PanelGrid makeGrid(const scene::Scene& scene, int wordRows) {
  const auto count = static_cast<int>(scene.panels.size());
  if (count == 0) return panelGrid(1, scene.clip.width, scene.clip.height);
  const PanelGrid grid = panelGrid(count, scene.clip.width, scene.clip.height - wordRows);
  if (std::min(grid.width, grid.height) >= kSmallestPanel) return grid;
  throw InputError(scene.name + ": " + std::to_string(count) + " panels have no room in " +
                   std::to_string(scene.clip.width) + "x" + std::to_string(scene.clip.height) +
                   " pixels; make the picture larger");
}

image::Image makeGround(const scene::Scene& scene) {
  image::Image ground(scene.clip.width, scene.clip.height, image::PixelFormat::Rgba8);
  for (int y = 0; y < ground.height(); ++y) {
    for (int x = 0; x < ground.width(); ++x) {
      std::ranges::copy(kGroundColour, ground.row(y) + static_cast<std::ptrdiff_t>(x) * 4);
    }
  }
  return ground;
}

}  // namespace

FrameDrawer::FrameDrawer(const scene::Scene& scene, const ClipMotion& motion)
    : motion_(&motion),
      overlays_(makeOverlays(scene)),
      grid_(makeGrid(scene, overlays_ ? overlays_->bottomRows() : 0)),
      renderer_(
          makeRenderer(scene, {grid_.width, grid_.height,
                               scene.panels.empty() && overlays_ ? overlays_->bottomRows() : 0})),
      ground_(makeGround(scene)),
      panel_(renderer_.makePicture()) {}

void FrameDrawer::draw(std::int64_t frame, image::Image& picture) {
  if (grid_.places.size() == 1) {
    drawMotion(0, frame, picture);
  } else {
    picture = ground_;
    for (std::size_t i = 0; i < grid_.places.size(); ++i) {
      drawMotion(i, frame, panel_);
      image::paste(panel_.view(), grid_.places[i].x, grid_.places[i].y, picture);
    }
  }
  if (overlays_) overlays_->draw(motion_->clockFrame(frame), picture);
}

void FrameDrawer::drawMotion(std::size_t motion, std::int64_t frame, image::Image& picture) {
  const auto& samples = motion_->trajectories()[motion].samples;
  renderer_.draw(samples[motion_->sampleAt(motion, frame)].corners, picture);
}

}  // namespace rotatebook::pipeline
