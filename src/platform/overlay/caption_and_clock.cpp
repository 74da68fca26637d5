#include "overlay/caption_and_clock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "overlay/canvas.h"
#include "overlay/layer.h"
#include "overlay/palette.h"
#include "overlay/text.h"
#include "scene/names.h"
#include "scene/source_locations.h"

namespace rotatebook::overlay {
namespace {

// Of the picture's height, less where it is narrow, but never so small that letters can't be read.
constexpr double kTitleSize = 0.036, kSmallestTitle = 13;
constexpr double kCaptionSize = 0.0255, kSmallestCaption = 10;
constexpr double kSettingsSize = 0.0215, kSmallestSettings = 9;
constexpr double kMargin = 0.045;
// A line longer than this many letter heights is hard to follow.
constexpr double kLongestLine = 56;
constexpr double kShade = 0.6;  // how dark the viewport of the words gets

/// The lengths that follow from the picture's size. [pixels]
struct PageScale {
  explicit PageScale(const scene::ClipSettings& clip)
      : width(clip.width),
        height(clip.height),
        unit(std::min<double>(height, 0.8 * width)),
        margin(static_cast<int>(std::lround(kMargin * unit))),
        room(width - 2 * margin) {}

  double size(double share, double least) const { return std::max(share * unit, least); }

  double halo() const { return std::max(1.0, 0.0024 * unit); }

  int width;
  int height;
  double unit;  // what letters and margins are shares of
  int margin;
  int room;  // between the margins
};

/// How a motion was simulated in steps: "quaternion", "rk4", "normalised", "step 0.26 ms".
std::vector<std::string> settingsOf(const physics::SimulationSettings& settings) {
  const std::string model(scene::nameOf(scene::kModels, settings.model));
  std::vector<std::string> parts{
      model, std::string(scene::nameOf(scene::kIntegrators, settings.integrator)),
      settings.normalize ? "normalised" : "not normalised"};
  if (settings.model == physics::Model::Particles) {
    parts.push_back(settings.damping > 0 ? "damping " + shortestText(settings.damping)
                                         : "undamped");
    parts.push_back("k = " + shortestText(settings.stiffness) + " N/m");
  }
  const double step = 1e3 * settings.timePerFrame / settings.substeps;
  parts.push_back("step " + roundedText(step, 3) + " ms");
  return parts;
}

/// What all motions of `scene` that are simulated in steps have in common, and whether one is
/// exact.
std::string settingsText(const scene::Scene& scene) {
  const std::vector<scene::Panel> motions = scene::motionsOf(scene);
  const auto steps = [](const scene::Panel& panel) {
    return panel.simulation.model != physics::Model::Exact;
  };
  constexpr const char* kExact = "exact solution";
  const auto first = std::ranges::find_if(motions, steps);
  if (first == motions.end()) return kExact;
  std::vector<std::string> common = settingsOf(first->simulation);
  std::erase_if(common, [&](const std::string& part) {
    return !std::ranges::all_of(motions, [&](const scene::Panel& panel) {
      return !steps(panel) || std::ranges::count(settingsOf(panel.simulation), part) > 0;
    });
  });
  return joined({joined(common), std::ranges::all_of(motions, steps) ? "" : kExact}, "; ");
}

/// Black, from nothing at the top to kShade at the bottom, softly.
Layer shade(int width, int height, int y) {
  Layer layer{0, y, width, height, {}};
  const auto rowSize = static_cast<std::size_t>(width) * 4;
  layer.pixels.resize(rowSize * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    const double t = (row + 0.5) / height;
    const auto opacity = static_cast<std::uint8_t>(std::lround(255 * kShade * t * t * (3 - 2 * t)));
    std::uint8_t* pixels = layer.pixels.data() + static_cast<std::size_t>(row) * rowSize;
    for (std::size_t alpha = 3; alpha < rowSize; alpha += 4) pixels[alpha] = opacity;
  }
  return layer;
}

std::string clockText(double time) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "t = %.2f s", time);
  return text.data();
}

TextStyle clockStyle(const PageScale& scale) {
  return {.size = scale.size(kCaptionSize, kSmallestCaption),
          .colour = kWhite,
          .opacity = 0.92,
          .halo = scale.halo(),
          .tabular = true};
}

struct Line {
  Layer words;
  int top;  // on the picture [pixels]
};

/// Throws InputError if the words leave too little of the picture for the book.
void refuseTooMany(const std::vector<Line>& lines, const scene::Scene& scene) {
  const int height = scene.clip.height, rows = height - lines.front().top;
  if (rows <= height / 2 || height < kSmallPicture) return;
  const auto tallest =
      std::ranges::max_element(lines, {}, [](const Line& line) { return line.words.height; });
  const bool title = tallest == lines.begin();
  throw InputError(
      scene::locationOf(scene, title ? "title" : "caption") + ": the words take " +
      std::to_string(rows) + " of the picture's " + std::to_string(height) +
      " rows, which leaves too little for the book; shorten " +
      (title ? "the title" : "the caption") +
      ", make the picture larger (clip.size), or leave \"caption\" out of overlay.show");
}

/// Title, caption and settings, one below the other, the last above the picture's lower margin; the
/// first is `narrower` than the others. [pixels]
std::vector<Line> captionLines(const Typesetter& type, const scene::Scene& scene, int narrower) {
  const PageScale scale(scene.clip);
  const double captionSize = scale.size(kCaptionSize, kSmallestCaption);
  const int room = std::min(scale.room, static_cast<int>(kLongestLine * captionSize));
  std::vector<Line> lines;
  const auto add = [&](std::string_view key, const std::string& text, const TextStyle& style) {
    if (text.empty()) return;
    const int width = lines.empty() ? std::min(room, scale.room - narrower) : room;
    const auto draw = [&] { return type.draw(text, style, width); };
    lines.push_back({scene::atLocationOf(scene, key, draw), 0});
  };
  const double halo = scale.halo();
  add("title", scene.title,
      {.size = scale.size(kTitleSize, kSmallestTitle),
       .bold = true,
       .colour = kWhite,
       .halo = halo});
  add("caption", scene.caption,
      {.size = captionSize, .colour = kWhite, .opacity = 0.95, .halo = halo});
  add("", settingsText(scene),
      {.size = scale.size(kSettingsSize, kSmallestSettings), .colour = kGrey, .halo = halo});

  const int gap = static_cast<int>(std::lround(0.45 * captionSize));
  int bottom = scale.height - scale.margin;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    line->top = bottom - static_cast<int>(boxOf(line->words, Point(0, 0)).height);
    bottom = line->top - gap;
  }
  refuseTooMany(lines, scene);
  return lines;
}

}  // namespace

struct CaptionAndClock::Parts {
  Parts(const scene::Scene& asked, ClockPosition clockPlace)
      : scene(asked), place(clockPlace), scale(asked.clip), type(Typesetter::of(asked)) {
    const bool below = shows(scene, scene::Overlay::Clock) && place == ClockPosition::Bottom;
    if (shows(scene, scene::Overlay::Clock)) clock = clockBox();
    std::vector<Line> lines;
    if (shows(scene, scene::Overlay::Caption)) {
      const int narrower = below ? static_cast<int>(clock.width) + scale.margin : 0;
      lines = captionLines(type, scene, narrower);
    }
    if (below) {
      clock.x = scale.width - scale.margin - clock.width;
      clock.y = lines.empty() ? scale.height - scale.margin - clock.height : lines.front().top;
    }
    if (!lines.empty()) {
      addShade(lines.front().top);
      addLines(lines);
    } else if (below) {
      addShade(static_cast<int>(clock.y));
    }
  }

  /// A dark viewport for words from row `first` on.
  void addShade(int first) {
    const int top = std::max(0, first - scale.margin / 2);
    bottomRows = std::min(scale.height - top, scale.height / 2);
    const int shadeTop = std::max(0, top - scale.margin);
    viewport = shade(scale.width, scale.height - shadeTop, shadeTop);
  }

  void addLines(const std::vector<Line>& lines) {
    Canvas canvas(scale.width, scale.height);
    for (const Line& line : lines) canvas.write(line.words, {1.0 * scale.margin, 1.0 * line.top});
    cached = canvas.take();
  }

  /// At the top left, wide enough for the last frame's time.
  Box clockBox() const {
    const double last =
        static_cast<double>(scene.clip.frameCount()) * scene.simulation.timePerFrame;
    const TextSize size = type.measure(clockText(last), clockStyle(scale), scale.room);
    return {1.0 * scale.margin, 1.0 * scale.margin, 1.0 * size.width, 1.0 * size.height};
  }

  scene::Scene scene;
  ClockPosition place;
  PageScale scale;
  Typesetter type;
  Layer viewport;      // below the words at the bottom
  CachedLayer cached;  // what is the same in every frame
  Box clock;           // empty if it isn't shown
  int bottomRows = 0;
  std::vector<Box> texts;
};

CaptionAndClock::CaptionAndClock(const scene::Scene& scene, ClockPosition place)
    : parts_(std::make_unique<Parts>(scene, place)) {}
CaptionAndClock::~CaptionAndClock() = default;
CaptionAndClock::CaptionAndClock(CaptionAndClock&&) noexcept = default;
CaptionAndClock& CaptionAndClock::operator=(CaptionAndClock&&) noexcept = default;

int CaptionAndClock::bottomRows() const {
  return parts_->bottomRows;
}

Box CaptionAndClock::corner() const {
  return parts_->place == ClockPosition::TopLeft ? parts_->clock : Box{};
}

void CaptionAndClock::draw(std::int64_t frame, image::Image& picture) {
  blend(parts_->viewport, picture);
  blend(parts_->cached.layer, picture);
  parts_->texts = parts_->cached.texts;
  if (parts_->clock.empty()) return;
  const PageScale& scale = parts_->scale;
  const double time = static_cast<double>(frame) * parts_->scene.simulation.timePerFrame;
  Layer clock = parts_->type.draw(clockText(time), clockStyle(scale), scale.room);
  parts_->texts.push_back(boxOf(clock, {parts_->clock.x, parts_->clock.y}));
  clock.x += static_cast<int>(parts_->clock.x);
  clock.y += static_cast<int>(parts_->clock.y);
  blend(clock, picture);
}

const std::vector<Box>& CaptionAndClock::texts() const {
  return parts_->texts;
}

}  // namespace rotatebook::overlay
