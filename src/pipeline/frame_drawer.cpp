#include "pipeline/frame_drawer.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/error.h"
#include "pipeline/textures.h"

namespace rotatebook::pipeline {
namespace {

constexpr int kSmallestPanel = 16;  // The shorter side. [pixels]
constexpr std::array<std::uint8_t, 4> kGroundColour{17, 17, 19, 255};

bool hasPanels(const scene::Scene& scene) {
  return !scene.panels.empty();
}

overlay::Words wordsOf(const scene::Scene& scene) {
  using Place = overlay::Words::ClockPlace;
  return overlay::Words(scene, hasPanels(scene) ? Place::Bottom : Place::TopLeft);
}

/// Panels are above the rows that words take; the picture of a single motion goes on below them.
PanelGrid gridOf(const scene::Scene& scene, const overlay::Words& words) {
  if (!hasPanels(scene)) return panelGrid(1, scene.clip.width, scene.clip.height);
  const auto count = static_cast<int>(scene.panels.size());
  const PanelGrid grid = panelGrid(count, scene.clip.width, scene.clip.height - words.bottomRows());
  if (std::min(grid.width, grid.height) >= kSmallestPanel) return grid;
  throw InputError(scene.name + ": " + std::to_string(count) + " panels have no room in " +
                   std::to_string(scene.clip.width) + "x" + std::to_string(scene.clip.height) +
                   " pixels; make the picture larger");
}

std::vector<overlay::Marks> marksOf(const scene::Scene& scene, const ClipMotion& motion,
                                    const PanelGrid& grid, const overlay::Words& words) {
  std::vector<overlay::Marks> marks;
  auto trajectory = motion.trajectories().begin();
  for (const scene::Panel& panel : scene::motionsOf(scene)) {
    overlay::Ground ground{.width = grid.width, .height = grid.height, .label = panel.label};
    if (!hasPanels(scene)) {
      ground.corner = words.corner();
      ground.bottomRows = words.bottomRows();
    }
    marks.emplace_back(scene::withMotion(scene, panel), *trajectory++, ground);
  }
  return marks;
}

/// A panel's picture. All leave as many rows to their marks, so that their books are of one size.
render::Screen screenOf(const PanelGrid& grid, const std::vector<overlay::Marks>& marks) {
  render::Screen screen{grid.width, grid.height, 0};
  for (const overlay::Marks& one : marks) {
    screen.bottomRows = std::max(screen.bottomRows, one.bottomRows());
  }
  return screen;
}

image::Image groundOf(const scene::Scene& scene) {
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
      frame_(scene.camera.frame),
      words_(wordsOf(scene)),
      grid_(gridOf(scene, words_)),
      marks_(marksOf(scene, motion, grid_, words_)),
      screen_(screenOf(grid_, marks_)),
      camera_(cameraOf(scene, screen_)),
      renderer_(makeRenderer(scene, screen_)),
      ground_(groundOf(scene)),
      panel_(renderer_.makePicture()),
      moments_(scene),
      mean_(grid_.width, grid_.height) {}

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
  words_.draw(motion_->clockFrame(frame), picture);
}

void FrameDrawer::drawMotion(std::size_t motion, std::int64_t frame, image::Image& picture) {
  const auto& samples = motion_->trajectories()[motion].samples;
  const std::size_t index = motion_->sampleAt(motion, frame);
  const physics::Corners corners = physics::seenFrom(frame_, samples[index]).corners;
  if (moments_.count() > 1) {
    drawBlurred(motion, index, picture);
  } else {
    renderer_.draw(corners, picture);
  }
  const render::Projection projection = render::project(camera_, corners, screen_);
  marks_[motion].draw(frame, projection.clipFromWorld, picture);
}

void FrameDrawer::drawBlurred(std::size_t motion, std::size_t sample, image::Image& picture) {
  for (std::size_t i = 0; i < moments_.count(); ++i) {
    renderer_.draw(physics::seenFrom(frame_, moments_.at(motion, sample, i)).corners, picture);
    mean_.add(picture.view());
  }
  mean_.take(picture);
}

}  // namespace rotatebook::pipeline
