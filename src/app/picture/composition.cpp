#include "picture/composition.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/text.h"
#include "scene/places.h"

namespace rotatebook::picture {
namespace {

constexpr int kSmallestPanel = 16;       // The shorter side. [pixels]
constexpr double kPanelLetters = 0.022;  // Of the picture's shorter side.
constexpr std::array<std::uint8_t, 4> kGroundColour{17, 17, 19, 255};

bool hasPanels(const scene::Scene& scene) {
  return !scene.panels.empty();
}

/// Panels are above the rows that words take; the picture of a single motion goes on below them.
PanelGrid gridOf(const scene::Scene& scene, const overlay::Words& words) {
  if (!hasPanels(scene)) return panelGrid(1, scene.clip.width, scene.clip.height);
  const auto count = static_cast<int>(scene.panels.size());
  const PanelGrid grid = panelGrid(count, scene.clip.width, scene.clip.height - words.bottomRows());
  if (std::min(grid.width, grid.height) >= kSmallestPanel) return grid;
  throw InputError(scene.name + ": " + std::to_string(count) + " panels have no room in " +
                   sizeText(scene.clip.width, scene.clip.height) +
                   " pixels; make the picture larger");
}

std::vector<overlay::Marks> marksOf(const scene::Scene& scene, const timeline::ClipMotion& motion,
                                    const PanelGrid& grid, const overlay::Words& words) {
  const std::vector<scene::Panel> panels = scene::motionsOf(scene);
  double energyTop = 0;
  for (const physics::Trajectory& trajectory : motion.trajectories()) {
    energyTop = std::max(energyTop, overlay::energyChartTop(trajectory));
  }
  std::vector<overlay::Marks> marks;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    overlay::Ground ground{.width = grid.width,
                           .height = grid.height,
                           .label = panels[i].label,
                           .labelKey = scene::labelKey(i),
                           .energyTop = energyTop};
    if (hasPanels(scene)) {
      ground.letters = kPanelLetters * std::min(scene.clip.width, scene.clip.height);
    } else {
      ground.corner = words.corner();
      ground.bottomRows = words.bottomRows();
    }
    marks.emplace_back(scene::withMotion(scene, panels[i]), motion.trajectories()[i], ground);
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
  if (scene::isTransparent(scene)) return ground;
  for (int y = 0; y < ground.height(); ++y) {
    for (int x = 0; x < ground.width(); ++x) {
      std::ranges::copy(kGroundColour, ground.row(y) + static_cast<std::ptrdiff_t>(x) * 4);
    }
  }
  return ground;
}

}  // namespace

overlay::Words wordsOf(const scene::Scene& scene) {
  using Place = overlay::Words::ClockPlace;
  return overlay::Words(scene, hasPanels(scene) ? Place::Bottom : Place::TopLeft);
}

Composition::Composition(const scene::Scene& scene, const timeline::ClipMotion& motion)
    : motion_(&motion),
      words_(wordsOf(scene)),
      grid_(gridOf(scene, words_)),
      marks_(marksOf(scene, motion, grid_, words_)),
      screen_(screenOf(grid_, marks_)),
      ground_(groundOf(scene)),
      panel_(screen_.width, screen_.height, image::PixelFormat::Rgba8) {}

void Composition::draw(std::int64_t frame, const DrawBook& drawBook, image::Image& picture) {
  if (grid_.places.size() == 1) {
    drawMotion(0, frame, drawBook, picture);
  } else {
    picture = ground_;
    for (std::size_t i = 0; i < grid_.places.size(); ++i) {
      drawMotion(i, frame, drawBook, panel_);
      image::paste(panel_.view(), grid_.places[i].x, grid_.places[i].y, picture);
    }
  }
  words_.draw(motion_->clockFrame(frame), picture);
}

void Composition::drawMotion(std::size_t motion, std::int64_t frame, const DrawBook& drawBook,
                             image::Image& picture) {
  const Eigen::Matrix4d clipFromWorld = drawBook(motion, motion_->sampleAt(motion, frame), picture);
  marks_[motion].draw(frame, clipFromWorld, picture);
}

}  // namespace rotatebook::picture
