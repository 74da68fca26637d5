#include "overlay/motion_overlays.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <utility>

#include "overlay/body_box.h"
#include "overlay/drawn_overlay.h"
#include "overlay/forces.h"
#include "overlay/layout.h"
#include "overlay/motion_text.h"
#include "overlay/strip_chart.h"

namespace rotatebook::overlay {
namespace {

using scene::Overlay;
using scene::OverlayRow;
using scene::Placement;

constexpr double kBold = 2;  // widens the lines of a textless picture, which is shown small
constexpr double kSmallestInset = 24;  // a smaller one can't be made out [pixels]
constexpr double kGlide = 0.07;  // frames this near are averaged, see ArrowLabels [s of the clip]

constexpr auto rowsAt(Placement placement) {
  return std::ranges::count(scene::kOverlayRows, placement, &OverlayRow::placement);
}

static_assert(rowsAt(Placement::Square) == 1, "layOut() has only one box for it");

/// The heights of an overlay's legend, whole and at least. [small letters]
struct LegendHeights {
  double whole = 0, least = 0;
};

LegendHeights legendHeights(Overlay overlay) {
  if (overlay == Overlay::Springs) return {2.6, 2.6};
  return {kForcesLegend, kForcesScale};
}

}  // namespace

struct MotionOverlays::Parts {
  Parts(const scene::Scene& asked, const physics::Trajectory& motion, const Viewport& viewport)
      : scene(asked),
        trajectory(motion),
        type(Typesetter::of(asked)),
        scale(viewport.width, viewport.height, asked.overlay.scale),
        energyTop(viewport.energyTop),
        seenFrom(scene::referenceFramesOf(asked).front()),
        canvas(image::Area{viewport.x, viewport.y, viewport.width, viewport.height}, Ink(asked)) {
    scale.enlargeLetters(viewport.letters);
    if (scene.textless) scale.line *= kBold;
    taken.push_back(viewport.corner);
    layout = layOut(scale, wanted(viewport));
    if (!viewport.hasHead) addCounts(viewport);
    const auto meetsText = [&](const Box& text) { return text.meets(layout.square); };
    if (std::ranges::any_of(taken, meetsText)) layout.square = {};
    taken.push_back({0, 1.0 * (viewport.height - layout.bottomRows), 1.0 * viewport.width,
                     1.0 * layout.bottomRows});
    for (const Box& box : layout.charts) taken.push_back(box);
    taken.push_back(layout.square);
    taken.push_back(layout.legend);
    addInWorld();
    addInsets();
    labels = ArrowLabels({0, 0, 1.0 * scale.width, 1.0 * scale.height}, taken,
                         static_cast<std::int64_t>(motion.samples.size()) - 1,
                         scene.clip.frameRate.framesIn(kGlide));
    if (motion.divergedAt && !scene.textless && !viewport.hasHead)
      notice = divergenceNotice(context(), *motion.divergedAt, taken);
  }

  OverlayContext context() const { return {scene, trajectory, type, scale, energyTop, seenFrom}; }

  bool shows(Overlay overlay) const {
    return scene::shows(scene, overlay) && isFor(scene.motions[0].simulation, overlay);
  }

  /// Returns the rows of the overlays that are drawn at `placements`, in drawing order.
  std::vector<OverlayRow> shownAt(std::initializer_list<Placement> placements) const {
    std::vector<OverlayRow> rows;
    for (const OverlayRow& row : scene::kOverlayRows) {
      if (std::ranges::count(placements, row.placement) > 0 && shows(row.overlay)) {
        rows.push_back(row);
      }
    }
    return rows;
  }

  Wanted wanted(const Viewport& viewport) const {
    const std::vector<OverlayRow> legends = shownAt({Placement::BodyAndLegend});
    LegendHeights legend;
    if (!legends.empty() && !scene.textless) legend = legendHeights(legends.front().overlay);
    return {.square = !shownAt({Placement::Square}).empty(),
            .charts = static_cast<int>(shownAt({Placement::Chart}).size()),
            .legend = legend.whole,
            .leastLegend = legend.least,
            .bottomRows = viewport.bottomRows};
  }

  void addInWorld() {
    bool hasRoom = layout.legend.width > 0;  // for the legend of one
    for (const OverlayRow& row : shownAt({Placement::Body, Placement::BodyAndLegend})) {
      const bool hasLegend = row.placement == Placement::BodyAndLegend && !scene.textless;
      if (hasLegend && !std::exchange(hasRoom, false)) {
        leftOut.push_back(row.overlay);
      } else {
        inWorld.push_back(makeOverlay(row.overlay, context(), layout.legend));
      }
    }
  }

  void addInsets() {
    auto chart = layout.charts.begin();
    for (const OverlayRow& row : shownAt({Placement::Square, Placement::Chart})) {
      const Box& box = row.placement == Placement::Chart ? *chart++ : layout.square;
      if (std::min(box.width, box.height) < kSmallestInset) {
        leftOut.push_back(row.overlay);
      } else {
        insets.push_back(makeOverlay(row.overlay, context(), box));
      }
    }
  }

  /// Adds the count of flips below the viewport's other text at the top left.
  void addCounts(const Viewport& viewport) {
    Point position(scale.margin, scale.margin);
    if (!viewport.corner.empty()) {
      position = {viewport.corner.x, viewport.corner.bottom() + 0.3 * scale.letters};
    }
    for (const OverlayRow& row : shownAt({Placement::TopLeft})) {
      insets.push_back(makeOverlay(row.overlay, context(), {position.x(), position.y(), 0, 0}));
      taken.push_back(insets.back()->box());
      position.y() = taken.back().bottom() + 0.3 * scale.letters;
    }
  }

  std::int64_t last() const { return static_cast<std::int64_t>(trajectory.samples.size()) - 1; }

  /// Calls draw(view) of a frame.
  template <typename Draw>
  void withView(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld, image::Image& picture,
                const Draw& draw) {
    const std::int64_t shown = std::min(frame, last());
    const physics::Sample sample = sampleAt(shown);
    draw(View{shown, sample, Projector(clipFromWorld, scale.width, scale.height), canvas, picture,
              frame > last()});
  }

  void drawInsets(const View& view, const Eigen::Matrix4d& clipFromWorld) {
    for (const auto& overlay : insets) overlay->draw(view);
    if (view.ended && notice) canvas.lay(*notice, view.picture);
    if (!scene.textless) {
      placeLetters(view.frame, view.ended, clipFromWorld);
      labels.write(canvas);
    }
    canvas.layOver(view.picture);
  }

  /// Returns what the insets show in many frames.
  std::vector<const CachedLayer*> stillAt(std::int64_t frame) const {
    std::vector<const CachedLayer*> layers;
    for (const auto& overlay : insets) {
      if (const CachedLayer* layer = overlay->still(std::min(frame, last())))
        layers.push_back(layer);
    }
    return layers;
  }

  /// Places letters of a frame of the motion, or of one after it has `ended`, beside the notice.
  void placeLetters(std::int64_t frame, bool ended, const Eigen::Matrix4d& clipFromWorld) {
    // The near and far planes follow the body; the rest changes only if the camera does.
    Eigen::Matrix<double, 3, 4> projection;
    projection << clipFromWorld.topRows<2>(), clipFromWorld.bottomRows<1>();
    if (projection != lettersProjection) labels.forget();
    lettersProjection = projection;
    const Projector projector(clipFromWorld, scale.width, scale.height);
    labels.place(
        frame, [&](std::int64_t n) { return arrowsAt(n, projector); },
        ended && notice ? notice->texts : std::vector<Box>{});
  }

  std::vector<LabelledArrow> arrowsAt(std::int64_t frame, const Projector& projector) const {
    const physics::Sample sample = sampleAt(frame);
    const BodyBox box(scene.motions[0].body, sample.cage);
    std::vector<LabelledArrow> all;
    for (const auto& overlay : inWorld) {
      for (const Arrow& arrow : overlay->arrows(sample)) {
        const auto shape = arrowShape(projector, box, arrow);
        all.push_back({shape.value_or(ArrowShape{}), arrow.letter, 0.85 * scale.arrowLetters,
                       arrow.wish, shape.has_value()});
      }
    }
    return all;
  }

  /// Returns a sample in the camera's frame of reference.
  physics::Sample sampleAt(std::int64_t frame) const {
    return seenFrom.seen(trajectory.samples[static_cast<std::size_t>(frame)]);
  }

  scene::Scene scene;
  const physics::Trajectory& trajectory;
  Typesetter type;
  Scale scale;
  double energyTop;
  scene::MotionFrame seenFrom;  // of the camera
  Canvas canvas;
  ArrowLabels labels;
  Eigen::Matrix<double, 3, 4> lettersProjection = Eigen::Matrix<double, 3, 4>::Zero();
  Layout layout;
  std::vector<Box> taken;  // areas that moving letters keep out of
  std::optional<CachedLayer> notice;
  std::vector<std::unique_ptr<DrawnOverlay>> inWorld;  // on and around the body, in drawing order
  std::vector<std::unique_ptr<DrawnOverlay>> insets;   // drawn above them
  std::vector<Overlay> leftOut;                        // without room
  std::vector<const CachedLayer*> still;               // of the insets, see stillAt()
};

MotionOverlays::MotionOverlays(const scene::Scene& scene, const physics::Trajectory& trajectory,
                               const Viewport& viewport)
    : parts_(std::make_unique<Parts>(scene, trajectory, viewport)) {}
MotionOverlays::~MotionOverlays() = default;
MotionOverlays::MotionOverlays(MotionOverlays&&) noexcept = default;
MotionOverlays& MotionOverlays::operator=(MotionOverlays&&) noexcept = default;

int MotionOverlays::bottomRows() const {
  return parts_->layout.bottomRows;
}

const std::vector<Overlay>& MotionOverlays::leftOut() const {
  return parts_->leftOut;
}

void MotionOverlays::draw(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld,
                          image::Image& picture) {
  setStill(frame);
  drawAroundBody(frame, clipFromWorld, picture);
  drawStill(picture);
  drawInsets(frame, clipFromWorld, picture);
}

bool MotionOverlays::setStill(std::int64_t frame) {
  std::vector<const CachedLayer*> still = parts_->stillAt(frame);
  std::swap(still, parts_->still);
  return still != parts_->still;
}

void MotionOverlays::drawAroundBody(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld,
                                    image::Image& picture) {
  parts_->canvas.forgetTexts();
  parts_->withView(frame, clipFromWorld, picture, [this](const View& view) {
    for (const auto& overlay : parts_->inWorld) overlay->draw(view);
  });
  // Tiles that it touches may be another panel's, too, whose insets are drawn over what is touched
  if (!parts_->still.empty()) parts_->canvas.layOver(picture);
}

void MotionOverlays::drawStill(image::Image& picture) {
  for (const CachedLayer* layer : parts_->still) parts_->canvas.layStill(*layer, picture);
}

void MotionOverlays::drawInsets(std::int64_t frame, const Eigen::Matrix4d& clipFromWorld,
                                image::Image& picture) {
  parts_->withView(frame, clipFromWorld, picture,
                   [&](const View& view) { parts_->drawInsets(view, clipFromWorld); });
}

const std::vector<Box>& MotionOverlays::texts() const {
  return parts_->canvas.texts();
}

double energyChartTop(const physics::Trajectory& trajectory) {
  return energyTop(trajectory);
}

const ArrowLabels& MotionOverlays::placeLetters(std::int64_t frame,
                                                const Eigen::Matrix4d& clipFromWorld) {
  const auto count = static_cast<std::int64_t>(parts_->trajectory.samples.size());
  parts_->placeLetters(std::min(frame, count - 1), frame >= count, clipFromWorld);
  return parts_->labels;
}

}  // namespace rotatebook::overlay
