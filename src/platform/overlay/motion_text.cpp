#include "overlay/motion_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

#include "base/error.h"
#include "scene/source_locations.h"

namespace rotatebook::overlay {
namespace {

constexpr double kTallestLabel = 0.2;  // of its panel
constexpr double kMinLines = 3;        // that a label may have however low its panel is
constexpr double kGlowTime = 0.7;      // of the clip, in which the count fades back to white [s]

std::string countText(int count) {
  return "Half-turns " + std::to_string(count);
}

TextStyle countStyle(const Scale& scale, double glow) {
  return {.size = scale.letters,
          .bold = true,
          .colour = mixed(kWhite, kVelocityColour, glow),
          .halo = scale.halo,
          .tabular = true};
}

std::string noticeText(double time) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "Diverged at t = %.2f s", time);
  return text.data();
}

/// `box`, moved down as far as it takes to meet none of `taken`.
Box movedBelow(Box box, const std::vector<Box>& taken, double gap) {
  const auto meets = [&](const Box& other) { return other.grown(gap).meets(box); };
  for (auto met = std::ranges::find_if(taken, meets); met != taken.end();
       met = std::ranges::find_if(taken, meets)) {
    box.y = std::ceil(met->bottom() + gap);
  }
  return box;
}

}  // namespace

CachedLayer labelLayer(const OverlayContext& context, const std::string& words, const Point& place,
                       double width) {
  const TextStyle style{.size = 1.1 * context.scale.letters,
                        .bold = true,
                        .colour = kWhite,
                        .halo = context.scale.halo};
  Canvas canvas(context.scale.width, context.scale.height);
  const Layer layer = context.type.draw(words, style, static_cast<int>(width));
  const double most = std::max(kTallestLabel * context.scale.height, kMinLines * style.size);
  if (layer.height > most && context.scene.clip.height >= kSmallPicture) {
    throw InputError("the label \"" + words + "\" takes " + std::to_string(layer.height) +
                     " of its panel's " + std::to_string(context.scale.height) +
                     " rows, which leaves too little for the book; shorten it, or make the "
                     "picture larger (clip.size)");
  }
  canvas.write(layer, place);
  return canvas.take();
}

HalfTurns::HalfTurns(const OverlayContext& context, const Box& place) : context_(context) {
  const int most = context.trajectory.samples.back().halfTurns;
  const TextSize size =
      context.type.measure(countText(most), countStyle(context.scale, 0), context.scale.width);
  box_ = {place.x, place.y, 1.0 * size.width, 1.0 * size.height};
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
  const double light = view.ended ? 0 : glow(view.frame);
  if (light > 0) {
    const double growth = (0.25 + 0.35 * light) * context_.scale.letters;
    view.canvas.roundedBox(box_.grown(growth / 2), growth / 2 + 2, {kVelocityColour, 0.22 * light});
  }
  view.canvas.write(context_.type.draw(countText(view.sample.halfTurns),
                                       countStyle(context_.scale, light), context_.scale.width),
                    {box_.x, box_.y});
}

std::optional<CachedLayer> divergenceNotice(const OverlayContext& context, double time,
                                            const std::vector<Box>& taken) {
  const Scale& scale = context.scale;
  const TextStyle style{.size = 1.25 * scale.letters, .bold = true, .colour = kWarningColour};
  const double padding = 0.6 * style.size;
  const Layer words =
      context.type.draw(noticeText(time), style, static_cast<int>(scale.width - 2 * (padding + 2)));
  const Box letters{std::round((scale.width - words.width) / 2.0), scale.margin + padding / 2,
                    1.0 * words.width, 1.0 * words.height};
  const Box pill = movedBelow({letters.x - padding, letters.y - padding / 2,
                               letters.width + 2 * padding, letters.height + padding},
                              taken, 0.3 * padding);
  if (pill.bottom() > scale.height) return std::nullopt;
  Canvas canvas(scale.width, scale.height);
  canvas.roundedBox(pill, 0.5 * style.size, {kDark, 0.82});
  canvas.write(words, {pill.x + padding, std::round(pill.y + padding / 2)});
  return canvas.take();
}

}  // namespace rotatebook::overlay
