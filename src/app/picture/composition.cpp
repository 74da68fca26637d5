#include "picture/composition.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "plot/grid_margins.h"
#include "scene/source_locations.h"

namespace rotatebook::picture {
namespace {

using plot::GridMargins;
using plot::PanelGrid;

constexpr int kSmallestPanel = 16;       // shorter side [pixels]
constexpr double kPanelLetters = 0.028;  // letter size, share of the picture's shorter side
constexpr std::array<std::uint8_t, 4> kBackgroundColour{17, 17, 19, 255};

/// Arranges the panels above the text; the picture of a single motion continues behind it.
PanelGrid gridOf(const scene::Scene& scene, const std::optional<GridMargins>& margins,
                 const overlay::CaptionAndClock& text) {
  if (margins) return margins->cells();
  if (!scene.hasPanels()) return plot::panelGrid(1, scene.clip.width, scene.clip.height);
  const auto count = static_cast<int>(scene.motions.size());
  const PanelGrid grid =
      plot::panelGrid(count, scene.clip.width, scene.clip.height - text.bottomRows());
  if (std::min(grid.width, grid.height) >= kSmallestPanel) return grid;
  throw InputError(fmt::format("{}: {} panels have no room in {} pixels; make the picture larger",
                               scene.name, count, sizeText(scene.clip.width, scene.clip.height)));
}

double panelLetters(const scene::Scene& scene) {
  return kPanelLetters * scene.overlay.scale * std::min(scene.clip.width, scene.clip.height);
}

std::optional<overlay::PanelHeads> headsOf(const scene::Scene& scene,
                                           const timeline::ClipMotion& motion,
                                           const PanelGrid& grid) {
  if (!scene.hasPanels()) return std::nullopt;
  overlay::PanelCells cells{.width = grid.width, .height = grid.height};
  for (const auto& [x, y] : grid.positions) cells.corners.emplace_back(x, y);
  cells.letters = scene.grid ? 0 : panelLetters(scene);  // A grid's are of the cell's own size
  return overlay::PanelHeads(scene, motion.trajectories(), cells);
}

/// Returns the pictures of the bodies, which are below the panels' heads.
PanelGrid below(const std::optional<overlay::PanelHeads>& heads, PanelGrid grid) {
  if (!heads) return grid;
  grid.height -= heads->rows();
  for (PanelGrid::Position& position : grid.positions) position.y += heads->rows();
  return grid;
}

std::vector<overlay::MotionOverlays> overlaysOf(const scene::Scene& scene,
                                                const timeline::ClipMotion& motion,
                                                const PanelGrid& grid,
                                                const std::optional<overlay::PanelHeads>& heads,
                                                const overlay::CaptionAndClock& text) {
  const std::vector<scene::Panel>& panels = scene.motions;
  double energyTop = 0;
  for (const physics::Trajectory& trajectory : motion.trajectories()) {
    energyTop = std::max(energyTop, overlay::energyChartTop(trajectory));
  }
  std::vector<overlay::MotionOverlays> overlays;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto& [x, y] = grid.positions[i];
    overlay::Viewport viewport{
        .width = grid.width, .height = grid.height, .energyTop = energyTop, .x = x, .y = y};
    if (heads) {
      viewport.hasHead = true;
      viewport.letters = scene.grid ? 0 : panelLetters(scene);
    } else {
      viewport.corner = text.corner();
      viewport.bottomRows = text.bottomRows();
    }
    overlays.emplace_back(scene::withMotion(scene, panels[i]), motion.trajectories()[i], viewport);
  }
  return overlays;
}

/// Returns a panel's screen. All panels leave equally many rows to their overlays, so that their
/// bodies have the same size.
geometry::Screen screenOf(const PanelGrid& grid,
                          const std::vector<overlay::MotionOverlays>& overlays) {
  geometry::Screen screen{grid.width, grid.height, 0};
  for (const overlay::MotionOverlays& one : overlays) {
    screen.bottomRows = std::max(screen.bottomRows, one.bottomRows());
  }
  return screen;
}

void paintBackground(const scene::Scene& scene, image::Image& background) {
  if (scene::isTransparent(scene)) return;
  std::array<std::uint8_t, 4> colour = kBackgroundColour;
  if (scene.look.background == scene::Background::Plain) {
    const auto& [red, green, blue] = scene.look.plainColour;
    colour = {red, green, blue, 255};
  }
  for (int y = 0; y < background.height(); ++y) {
    for (int x = 0; x < background.width(); ++x) {
      std::ranges::copy(colour, background.row(y) + static_cast<std::ptrdiff_t>(x) * 4);
    }
  }
}

/// Returns what is between the panels, and around a grid.
image::Image backgroundOf(const scene::Scene& scene, const std::optional<GridMargins>& margins) {
  image::Image background(scene.clip.width, scene.clip.height, image::PixelFormat::Rgba8);
  paintBackground(scene, background);
  if (margins) margins->draw(background);
  return background;
}

std::optional<GridMargins> marginsOf(const scene::Scene& scene,
                                     const overlay::CaptionAndClock& text) {
  if (!scene.grid) return std::nullopt;
  return GridMargins(scene, text.bottomRows());
}

}  // namespace

overlay::CaptionAndClock captionAndClockOf(const scene::Scene& scene) {
  using Position = overlay::CaptionAndClock::ClockPosition;
  return overlay::CaptionAndClock(scene, scene.hasPanels() ? Position::Bottom : Position::TopLeft);
}

Composition::Composition(const scene::Scene& scene, const timeline::ClipMotion& motion)
    : motion_(&motion),
      captionAndClock_(captionAndClockOf(scene)),
      margins_(marginsOf(scene, captionAndClock_)),
      heads_(headsOf(scene, motion, gridOf(scene, margins_, captionAndClock_))),
      grid_(below(heads_, gridOf(scene, margins_, captionAndClock_))),
      overlays_(overlaysOf(scene, motion, grid_, heads_, captionAndClock_)),
      screen_(screenOf(grid_, overlays_)),
      background_(backgroundOf(scene, margins_)) {}

std::vector<scene::Overlay> Composition::leftOut() const {
  std::set<scene::Overlay> all;
  for (const overlay::MotionOverlays& one : overlays_)
    all.insert(one.leftOut().begin(), one.leftOut().end());
  return {all.begin(), all.end()};
}

void Composition::setBackground(const image::Image& ofBody) {
  const bool isOnly =
      ofBody.width() == background_.width() && ofBody.height() == background_.height();
  if (isOnly) {
    ofOnlyBody_ = &ofBody;
    background_ = {};
  } else {
    for (const auto& [x, y] : grid_.positions) image::paste(ofBody.view(), x, y, background_);
  }
  still_ = {};
}

void Composition::draw(std::int64_t frame, const DrawBody& drawBody, image::Image& picture) {
  setStill(frame);
  picture.beginOn(ground());
  std::vector<Eigen::Matrix4d> projections;
  for (std::size_t i = 0; i < overlays_.size(); ++i) {
    projections.push_back(drawBody(i, motion_->sampleAt(i, frame), grid_.positions[i], picture));
    overlays_[i].drawAroundBody(frame, projections[i], picture);
  }
  for (overlay::MotionOverlays& one : overlays_) one.drawStill(picture);
  picture.goOnOver(withInsets_);
  for (std::size_t i = 0; i < overlays_.size(); ++i)
    overlays_[i].drawInsets(frame, projections[i], picture);
  if (heads_) heads_->draw(frame, picture);
  captionAndClock_.drawCaption(picture);
  picture.settle(still_);
  captionAndClock_.drawClock(motion_->clockFrame(frame), picture);
}

void Composition::setStill(std::int64_t frame) {
  bool isOther = captionAndClock_.setCaption(frame) || still_.width() == 0;
  for (overlay::MotionOverlays& one : overlays_) isOther = one.setStill(frame) || isOther;
  if (!isOther) return;
  withInsets_ = ground();
  for (overlay::MotionOverlays& one : overlays_) one.drawStill(withInsets_);
  still_ = withInsets_;
  captionAndClock_.drawCaption(still_);
  still_.mark();
}

}  // namespace rotatebook::picture
