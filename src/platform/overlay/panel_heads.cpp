#include "overlay/panel_heads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "overlay/drawn_overlay.h"
#include "overlay/motion_text.h"
#include "scene/source_locations.h"

namespace rotatebook::overlay {
namespace {

using scene::OverlayRow;
using scene::Placement;

constexpr double kPadding = 0.35;  // above and below the texts [letter heights]
constexpr double kGap = 0.8;       // between texts of one line [letter heights]
constexpr double kLineGap = 0.15;  // between lines [letter heights]

/// The texts of a head, which take less room from one to the next.
enum class Texts {
  All,
  BriefNotice,
  NoticeOverCounts,  ///< In their place, once the motion has ended.
  NoNotice,
  LabelAlone,
  ShortLabel,  ///< Only those that have room.
};

/// The texts that a head tries to have, in its panel or one in `parts` of it.
struct Attempt {
  Texts texts;
  int parts;
};
constexpr Attempt kAllWords[] = {{Texts::All, 3},
                                 {Texts::BriefNotice, 3},
                                 {Texts::NoticeOverCounts, 3},
                                 {Texts::NoticeOverCounts, 2}};
constexpr double kSmallerLetters = 0.8;  // with which it tries these
constexpr Attempt kFewerWords[] = {{Texts::NoticeOverCounts, 2},
                                   {Texts::NoNotice, 2},
                                   {Texts::LabelAlone, 2},
                                   {Texts::ShortLabel, 1}};

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
    end = first + 1;
    if (sizes[first].width == 0) continue;
    double used = sizes[first].width;
    int height = sizes[first].height;
    for (; end < sizes.size(); ++end) {
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
  std::optional<Layer> label, notice, briefNotice;
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
    addHeads(motions);
    if (!isArranged(kAllWords)) {
      refuseTooHigh();
      scale.letters *= kSmallerLetters;
      addHeads(motions);
      isArranged(kFewerWords);
    }
    for (std::size_t i = 0; i < heads.size(); ++i) keepArranged(i);
  }

  double room() const { return std::max(1.0, cells.width - 2 * margin); }

  OverlayContext contextOf(const Head& head) const {
    return {head.scene, *head.motion, type, scale};
  }

  void addHeads(const std::vector<physics::Trajectory>& motions) {
    heads.clear();
    for (std::size_t i = 0; i < motions.size(); ++i) addHead(i, motions[i]);
  }

  void addHead(std::size_t panel, const physics::Trajectory& motion) {
    Head& head = *heads.emplace_back(std::make_unique<Head>());
    head.scene = scene::withMotion(scene, scene.motions[panel]);
    head.motion = &motion;
    if (scene.textless) return;
    if (motion.divergedAt) {
      const auto notice = [&](DivergenceText text) {
        return divergenceLayer(contextOf(head), *motion.divergedAt, room(), text);
      };
      head.notice = notice(DivergenceText::Whole);
      head.briefNotice = notice(DivergenceText::Brief);
    }
    // The values of a grid are in its margins
    if (scene.grid) return;
    const std::string& label = scene.motions[panel].label;
    head.label = scene::atLocationOf(scene, scene::labelKey(panel),
                                     [&] { return labelLayer(contextOf(head), label, room()); });
    mirrored = mirrored || type.isReadFromTheRight(label);
  }

  std::unique_ptr<DrawnOverlay> countOf(const Head& head, const OverlayRow& row,
                                        const Box& box) const {
    if (!isFor(head.scene.motions[0].simulation, row.overlay)) return nullptr;
    return makeOverlay(row.overlay, contextOf(head), box);
  }

  bool hasRoom(const Layer& label) const {
    return texts != Texts::ShortLabel ||
           boxOf(label).height + 2 * kPadding * scale.letters <= cells.height / 2;
  }

  /// Returns which kind of text's place the notice has: the label's is 0.
  std::size_t placeOfNotice() const {
    return texts == Texts::NoticeOverCounts && !counts.empty() ? 1 : counts.size() + 1;
  }

  /// Returns the sizes of the largest label, of each count, and of the largest notice.
  std::vector<TextSize> sizes() const {
    std::vector<TextSize> largest(counts.size() + 2);
    const auto widen = [&](std::size_t kind, const Box& text) {
      largest[kind] = widened(largest[kind], text);
    };
    for (const auto& head : heads) {
      const auto& notice = texts == Texts::All ? head->notice : head->briefNotice;
      if (head->label && hasRoom(*head->label)) widen(0, boxOf(*head->label));
      if (notice && texts < Texts::NoNotice) widen(placeOfNotice(), boxOf(*notice));
      for (std::size_t i = 0; i < counts.size() && texts < Texts::LabelAlone; ++i) {
        const auto count = countOf(*head, counts[i], {});
        if (count) widen(i + 1, count->box());
      }
    }
    return largest;
  }

  /// Arranges the texts of the first attempt that succeeds; returns whether one did.
  bool isArranged(std::span<const Attempt> attempts) {
    return std::ranges::any_of(attempts, [this](const Attempt& attempt) {
      arrange(attempt.texts);
      return height <= cells.height / attempt.parts;
    });
  }

  void arrange(Texts which) {
    texts = which;
    places = arranged(sizes(), room(), scale.letters);
    double bottom = 0;
    for (Box& place : places) {
      place = place.moved({margin, std::round(kPadding * scale.letters)});
      if (!place.empty()) bottom = std::max(bottom, place.bottom());
    }
    height = bottom > 0 ? static_cast<int>(std::ceil(bottom + kPadding * scale.letters)) : 0;
  }

  /// Throws InputError unless the picture is small, or a grid, and may lack words.
  void refuseTooHigh() const {
    if (scene.grid || scene.textless || scene.clip.height < kSmallPicture) return;
    const auto heightOf = [](const auto& head) { return head->label->height; };
    const auto panel = std::ranges::max_element(heads, {}, heightOf) - heads.begin();
    scene::atLocationOf(scene, scene::labelKey(static_cast<std::size_t>(panel)), [&] {
      throw InputError(
          fmt::format("the words above a panel take {} of its {} rows, which leaves too little for "
                      "the book; shorten the label, or make the picture larger (clip.size)",
                      height, cells.height));
    });
  }

  /// Leaves the texts of a panel out that have no place.
  void keepArranged(std::size_t panel) {
    Head& head = *heads[panel];
    if (texts != Texts::All) head.notice = std::move(head.briefNotice);
    if (texts >= Texts::NoNotice) head.notice.reset();
    if (head.label && !hasRoom(*head.label)) head.label.reset();
    if (texts < Texts::LabelAlone) addCounts(panel);
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
    const physics::Sample& sample = head.motion->samples[static_cast<std::size_t>(frame)];
    const View view{
        frame,  sample,  Projector(Eigen::Matrix4d::Identity(), cells.width, cells.height),
        canvas, picture, ended};
    const bool hasNotice = ended && head.notice;
    for (const auto& count : head.counts) {
      if (!hasNotice || texts != Texts::NoticeOverCounts) count->draw(view);
    }
    if (hasNotice) write(*head.notice, panel, placeOfNotice());
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
  Texts texts = Texts::All;
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
  return parts_->height;
}

void PanelHeads::draw(std::int64_t frame, image::Image& picture) {
  parts_->canvas.forgetTexts();
  for (std::size_t i = 0; i < parts_->heads.size(); ++i) parts_->draw(i, frame, picture);
}

const std::vector<Box>& PanelHeads::texts() const {
  return parts_->canvas.texts();
}

}  // namespace rotatebook::overlay
