#include "overlay/motion_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"

namespace rotatebook::overlay {
namespace {

constexpr double kTallestLabel = 0.2;  // share of its panel's height
constexpr double kMinLines = 3;        // a label may have as many however low its panel is
constexpr double kGlowTime = 0.7;      // in which the count fades back to white [s of the clip]

constexpr const char* kFixedSpace = "\u00a0";  // at which no line is broken

/// Returns "22.53 s", or "t = 22.53 s", which stay on one line.
std::string momentText(double time, const scene::Words& words, bool isBrief) {
  std::string moment = (isBrief ? "" : "t = ") + clockText(time, words);
  for (auto at = moment.find(' '); at != moment.npos; at = moment.find(' ', at))
    moment.replace(at, 1, kFixedSpace);
  return moment;
}

std::string countText(const OverlayContext& context, int count) {
  return fmt::format("{} {}", context.scene.overlay.words[scene::Word::Flips], count);
}

TextStyle countStyle(const Scale& scale, double glow) {
  return {.size = scale.letters,
          .bold = true,
          .colour = mixed(kWhite, kVelocityColour, glow),
          .halo = scale.halo,
          .tabular = true};
}

/// Returns `box`, moved down as far as necessary to keep a `gap` to all that is `taken`.
Box movedBelow(Box box, const std::vector<Box>& taken, double gap) {
  const auto meets = [&](const Box& other) { return other.grown(gap).meets(box); };
  for (auto met = std::ranges::find_if(taken, meets); met != taken.end();
       met = std::ranges::find_if(taken, meets)) {
    box.y = std::ceil(met->bottom() + gap);
  }
  return box;
}

}  // namespace

Layer labelLayer(const OverlayContext& context, const std::string& label, double width) {
  const TextStyle style{.size = 1.1 * context.scale.letters,
                        .bold = true,
                        .colour = kWhite,
                        .halo = context.scale.halo};
  Layer layer = context.type.draw(label, style, static_cast<int>(width));
  const double max = std::max(kTallestLabel * context.scale.height, kMinLines * style.size);
  if (layer.height > max && context.scene.clip.height >= kSmallPicture) {
    throw InputError(
        fmt::format("the label \"{}\" takes {} of its panel's {} rows, which leaves too little for "
                    "the book; shorten it, or make the picture larger (clip.size)",
                    label, layer.height, context.scale.height));
  }
  return layer;
}

Layer divergenceLayer(const OverlayContext& context, double time, double width,
                      DivergenceText text) {
  const bool isBrief = text == DivergenceText::Brief;
  const TextStyle style{.size = (isBrief ? 0.9 : 1) * context.scale.letters,
                        .bold = true,
                        .colour = kWarningColour,
                        .halo = context.scale.halo,
                        .tabular = true};
  const scene::Words& words = context.scene.overlay.words;
  return context.type.draw(words[scene::Word::DivergedAt] + " " + momentText(time, words, isBrief),
                           style, static_cast<int>(width));
}

namespace {

/// "Flips 3", which lights up when the book turns over.
class HalfTurns final : public DrawnOverlay {
 public:
  /// Takes the top left of `area`.
  HalfTurns(const OverlayContext& context, const Box& area);
  void draw(const View& view) override;
  Box box() const override { return box_; }

 private:
  double glow(std::int64_t frame) const;
  /// Returns the text, which mostly is the last frame's.
  const Layer& textOf(int count, double glowing);

  OverlayContext context_;
  Box box_;
  std::pair<int, double> shown_{-1, 0};  // What text_ shows: the count and its glow.
  Layer text_;
};

HalfTurns::HalfTurns(const OverlayContext& context, const Box& area) : context_(context) {
  const std::string last = countText(context, context.trajectory.samples.back().halfTurns);
  const TextSize size =
      context.type.measure(last, countStyle(context.scale, 0), context.scale.width);
  box_ = {area.x, area.y, 1.0 * size.width, 1.0 * size.height};
}

double HalfTurns::glow(std::int64_t frame) const {
  const auto& samples = context_.trajectory.samples;
  const auto now = static_cast<std::size_t>(frame);
  const auto period = context_.scene.clip.frameRate.period();
  const auto fade = static_cast<std::size_t>(std::ceil(kGlowTime / period));
  for (std::size_t back = 0; back < fade && back < now; ++back) {
    if (samples[now - back].halfTurns != samples[now - back - 1].halfTurns) {
      return 1 - static_cast<double>(back) / static_cast<double>(fade);
    }
  }
  return 0;
}

void HalfTurns::draw(const View& view) {
  const double glowing = view.ended ? 0 : glow(view.frame);
  if (glowing > 0) {
    const double growth = (0.25 + 0.35 * glowing) * context_.scale.letters;
    view.canvas.roundedBox(box_.grown(growth / 2), growth / 2 + 2,
                           {kVelocityColour, 0.22 * glowing});
  }
  view.canvas.write(textOf(view.sample.halfTurns, glowing), {box_.x, box_.y});
}

const Layer& HalfTurns::textOf(int count, double glowing) {
  if (shown_ != std::pair(count, glowing)) {
    text_ = context_.type.draw(countText(context_, count), countStyle(context_.scale, glowing),
                               context_.scale.width);
    shown_ = {count, glowing};
  }
  return text_;
}

}  // namespace

std::unique_ptr<DrawnOverlay> makeHalfTurns(const OverlayContext& context, const Box& area) {
  return std::make_unique<HalfTurns>(context, area);
}

namespace {

/// Writes a notice, the time on a line of its own if that keeps it beside the body, in letters of
/// `size` [pixels] at the top left, below all that is `taken`; nothing if it has no room.
std::optional<CachedLayer> noticeOf(const OverlayContext& context, const std::string& words,
                                    const std::string& time, double size,
                                    const std::vector<Box>& taken) {
  const Scale& scale = context.scale;
  const TextStyle style{.size = size, .bold = true, .colour = kWarningColour};
  const double padding = 0.6 * style.size;
  const auto widthOf = [&](const std::string& text) {
    return context.type.measure(text, style, scale.width).width;
  };
  const double side = (scale.width - scale.height) / 2.0 - scale.margin - 2 * padding;
  const bool hasSide = std::max(widthOf(words), widthOf(time)) < side;
  const double room = hasSide ? side : scale.width - 2 * (padding + 2);
  const Layer text = context.type.draw(words + " " + time, style, static_cast<int>(room));
  const double width = text.width + 2 * padding;
  const double left = std::min(std::round(scale.margin), std::floor((scale.width - width) / 2));
  const Box box =
      movedBelow({left, scale.margin, width, text.height + padding}, taken, 0.3 * padding);
  if (box.bottom() > scale.height) return std::nullopt;
  Canvas canvas = context.canvas();
  canvas.roundedBox(box, 0.5 * style.size, {kDark, 0.82});
  canvas.write(text, {box.x + padding, std::round(box.y + padding / 2)});
  return canvas.take();
}

}  // namespace

std::optional<CachedLayer> divergenceNotice(const OverlayContext& context, double time,
                                            const std::vector<Box>& taken) {
  const double letters = context.scale.letters;
  const scene::Words& words = context.scene.overlay.words;
  const std::string& diverged = words[scene::Word::DivergedAt];
  auto notice = noticeOf(context, diverged, momentText(time, words, false), 1.25 * letters, taken);
  if (!notice)
    notice = noticeOf(context, diverged, momentText(time, words, true), 0.9 * letters, taken);
  return notice;
}

}  // namespace rotatebook::overlay
