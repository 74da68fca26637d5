#include "overlay/panel_heads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "overlay/drawn_overlay.h"
#include "overlay/motion_text.h"
#include "scene/source_locations.h"

namespace rotatebook::overlay {
namespace {

using scene::OverlayRow;
using scene::Placement;

constexpr double kPadding = 0.35;   // above and below the texts [letter heights]
constexpr double kGap = 0.8;        // between texts of one line [letter heights]
constexpr double kLineGap = 0.15;   // between lines [letter heights]
constexpr int kLargestShareOf = 3;  // the head takes up to one third of its panel

/// Returns `place`, at least as large as `text`.
TextSize widened(const TextSize& place, const Box& text) {
  return {std::max(place.width, static_cast<int>(std::ceil(text.width))),
          std::max(place.height, static_cast<int>(std::ceil(text.height)))};
}

/// Arranges texts of these sizes, empty ones left out, in lines as wide as `room`: the first of a
/// line begins on the left, the others end on the right. Returns the box of each. [pixels]
std::vector<Box> arranged(const std::vector<TextSize>& sizes, double room, double letters) {
  std::vector<Box> places(sizes.size());
  double top = 0;
  for (std::size_t first = 0, end = 0; first < sizes.size(); first = end) {
    double used = sizes[first].width;
    int height = sizes[first].height;
    for (end = first + 1; end < sizes.size(); ++end) {
      if (sizes[end].width > 0) used += kGap * letters + sizes[end].width;
      if (used > room) break;
      height = std::max(height, sizes[end].height);
    }
    double right = room;
    for (std::size_t i = end; i-- > first;) {
      const auto& [width, own] = sizes[i];
      places[i] = {i == first ? 0 : std::round(right - width), top + height - own, 1.0 * width,
                   1.0 * own};
      if (width > 0) right = places[i].x - kGap * letters;
    }
    top += std::round(height + kLineGap * letters);
  }
  return places;
}

/// The texts of one panel.
struct Head {
  scene::Scene scene;  // with this panel's motion
  const physics::Trajectory* motion;
  std::optional<Layer> label, notice;
  std::vector<std::unique_ptr<DrawnOverlay>> counts;
};

}  // namespace

struct PanelHeads::Parts {
  Parts(const scene::Scene& asked, const std::vector<physics::Trajectory>& motions,
        const PanelCells& panelCells)
      : scene(asked),
        cells(panelCells),
        type(Typesetter::of(asked)),
        scale(cells.width, cells.height, asked.overlay.scale),
        margin(std::round(scale.margin)),
        canvas(asked.clip.width, asked.clip.height, Ink(asked)) {
    scale.enlargeLetters(cells.letters);
    for (const OverlayRow& row : scene::kOverlayRows) {
      if (row.placement == Placement::TopLeft && shows(scene, row.overlay)) counts.push_back(row);
    }
    for (std::size_t i = 0; i < motions.size(); ++i) addHead(i, motions[i]);
    places = arranged(sizes(), room(), scale.letters);
    double bottom = 0;
    for (Box& place : places) {
      place = place.moved({margin, std::round(kPadding * scale.letters)});
      if (!place.empty()) bottom = std::max(bottom, place.bottom());
    }
    if (bottom > 0) height = static_cast<int>(std::ceil(bottom + kPadding * scale.letters));
    for (std::size_t i = 0; i < heads.size(); ++i) addCounts(i);
  }

  double room() const { return std::max(1.0, cells.width - 2 * margin); }

  OverlayContext contextOf(const Head& head) const {
    return {head.scene, *head.motion, type, scale};
  }

  void addHead(std::size_t panel, const physics::Trajectory& motion) {
    Head& head = *heads.emplace_back(std::make_unique<Head>());
    head.scene = scene::withMotion(scene, scene.panels[panel]);
    head.motion = &motion;
    if (scene.textless) return;
    const std::string& label = scene.panels[panel].label;
    head.label = scene::atLocationOf(scene, scene::labelKey(panel),
                                     [&] { return labelLayer(contextOf(head), label, room()); });
    mirrored = mirrored || type.isReadFromTheRight(label);
    if (motion.divergedAt)
      head.notice = divergenceLayer(contextOf(head), *motion.divergedAt, room());
  }

  std::unique_ptr<DrawnOverlay> countOf(const Head& head, const OverlayRow& row,
                                        const Box& box) const {
    if (!isFor(head.scene.simulation, row.overlay)) return nullptr;
    return makeOverlay(row.overlay, contextOf(head), box);
  }

  /// Returns the sizes of the largest label, of each count, and of the largest notice.
  std::vector<TextSize> sizes() const {
    std::vector<TextSize> largest(counts.size() + 2);
    for (const auto& head : heads) {
      if (head->label) largest.front() = widened(largest.front(), boxOf(*head->label));
      if (head->notice) largest.back() = widened(largest.back(), boxOf(*head->notice));
      for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto count = countOf(*head, counts[i], {});
        if (count) largest[i + 1] = widened(largest[i + 1], count->box());
      }
    }
    return largest;
  }

  /// Returns the place of a text, `width` wide, on the picture.
  Box placeOf(std::size_t panel, std::size_t kind, double width) const {
    Box place = places[kind];
    if (mirrored) place.x = cells.width - place.x - width;
    return place.moved(cells.corners[panel]);
  }

  void addCounts(std::size_t panel) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const Box place = placeOf(panel, i + 1, places[i + 1].width);
      auto count = countOf(*heads[panel], counts[i], place);
      if (count) heads[panel]->counts.push_back(std::move(count));
    }
  }

  void write(const Layer& text, std::size_t panel, std::size_t kind) {
    const Box place = placeOf(panel, kind, boxOf(text).width);
    canvas.write(text, {place.x, place.y});
  }

  void draw(std::size_t panel, std::int64_t frame, image::Image& picture) {
    const Head& head = *heads[panel];
    const auto last = static_cast<std::int64_t>(head.motion->samples.size()) - 1;
    const bool ended = frame > last;
    frame = std::min(frame, last);
    if (head.label) write(*head.label, panel, 0);
    const physics::Sample sample = scene::inReferenceFrame(
        scene.camera.frame, head.motion->samples[static_cast<std::size_t>(frame)]);
    const View view{
        frame,  sample,  Projector(Eigen::Matrix4d::Identity(), cells.width, cells.height),
        canvas, picture, ended};
    for (const auto& count : head.counts) count->draw(view);
    if (ended && head.notice) write(*head.notice, panel, places.size() - 1);
    canvas.layOver(picture);
  }

  scene::Scene scene;
  PanelCells cells;
  Typesetter type;
  Scale scale;    // of a panel
  double margin;  // [pixels]
  Canvas canvas;
  std::vector<OverlayRow> counts;
  std::vector<std::unique_ptr<Head>> heads;  // of each panel
  bool mirrored = false;                     // The labels begin at the right.
  std::vector<Box> places;  // In a panel: of the label, of each count, of the notice. [pixels]
  int height = 0;           // [pixels]
};

PanelHeads::PanelHeads(const scene::Scene& scene, const std::vector<physics::Trajectory>& motions,
                       const PanelCells& cells)
    : parts_(std::make_unique<Parts>(scene, motions, cells)) {}
PanelHeads::~PanelHeads() = default;
PanelHeads::PanelHeads(PanelHeads&&) noexcept = default;
PanelHeads& PanelHeads::operator=(PanelHeads&&) noexcept = default;

int PanelHeads::rows() const {
  return std::min(parts_->height, parts_->cells.height / kLargestShareOf);
}

int PanelHeads::rowsOnPicture() const {
  return parts_->height - rows();
}

void PanelHeads::draw(std::int64_t frame, image::Image& picture) {
  parts_->canvas.forgetTexts();
  for (std::size_t i = 0; i < parts_->heads.size(); ++i) parts_->draw(i, frame, picture);
}

const std::vector<Box>& PanelHeads::texts() const {
  return parts_->canvas.texts();
}

}  // namespace rotatebook::overlay
