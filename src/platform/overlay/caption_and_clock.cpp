#include "overlay/caption_and_clock.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "overlay/canvas.h"
#include "overlay/layer.h"
#include "overlay/palette.h"
#include "overlay/text.h"
#include "scene/correction_text.h"
#include "scene/names.h"
#include "scene/source_locations.h"

namespace rotatebook::overlay {
namespace {

using scene::Word;

// Font sizes: shares of Scale::unit, and the smallest that can be read. [pixels]
constexpr double kTitleSize = 0.046, kSmallestTitle = 13;
constexpr double kSettingsSize = 0.0255, kSmallestSettings = 9;
// A line longer than this many letter heights is hard to follow.
constexpr double kLongestLine = 56;
// Opacity of the shade below the text: over a white page, letters have 4.5 times its light.
constexpr double kShade = 0.64;

Word wordOf(physics::Model model) {
  switch (model) {
    case physics::Model::Particles:
      return Word::Particles;
    case physics::Model::Matrix:
      return Word::Matrix;
    case physics::Model::Quaternion:
      return Word::Quaternion;
    case physics::Model::Recorded:
      return Word::Recorded;
    case physics::Model::Exact:
      break;
  }
  return Word::ExactSolution;
}

/// Lists the settings of a motion in steps: "quaternion", "rk4", "normalised", "step 0.26 ms".
std::vector<std::string> settingsOf(const physics::SimulationSettings& settings,
                                    const scene::Words& words) {
  std::vector<std::string> parts{words[wordOf(settings.model)],
                                 words.of(scene::nameOf(scene::kIntegrators, settings.integrator))};
  std::ranges::copy(scene::correctionTexts(settings, words), std::back_inserter(parts));
  if (settings.model == physics::Model::Particles) {
    parts.push_back(settings.damping > 0
                        ? words[Word::Damping] + " " + words.number(shortestText(settings.damping))
                        : words[Word::Undamped]);
    parts.push_back(fmt::format("k = {} N/m", words.number(shortestText(settings.stiffness))));
  }
  if (settings.dissipates()) {
    parts.push_back(fmt::format("{} {} kg m²\u00a0s", words[Word::Dissipation],
                                words.number(shortestText(settings.dissipation))));
  }
  const double step = 1e3 * settings.steps().length();
  parts.push_back(fmt::format("{} {} ms", words[Word::Step], words.number(roundedText(step, 3))));
  return parts;
}

/// Lists the models without steps among `motions`: "exact solution", "recorded".
std::string steplessText(const std::vector<scene::Panel>& motions, const scene::Words& words) {
  std::vector<std::string> texts;
  for (const scene::Panel& panel : motions) {
    const std::string& text = words[wordOf(panel.simulation.model)];
    const bool isNew = std::ranges::count(texts, text) == 0;
    if (isNew && !physics::takesSteps(panel.simulation.model)) texts.push_back(text);
  }
  return joined(texts);
}

/// Lists the settings that all motions of `scene` in steps have in common, and the models without
/// steps.
std::string settingsText(const scene::Scene& scene) {
  const std::vector<scene::Panel>& motions = scene.motions;
  const auto steps = [](const scene::Panel& panel) {
    return physics::takesSteps(panel.simulation.model);
  };
  const scene::Words& words = scene.overlay.words;
  const auto first = std::ranges::find_if(motions, steps);
  if (first == motions.end()) return steplessText(motions, words);
  std::vector<std::string> common = settingsOf(first->simulation, words);
  std::erase_if(common, [&](const std::string& part) {
    return !std::ranges::all_of(motions, [&](const scene::Panel& panel) {
      return !steps(panel) || std::ranges::count(settingsOf(panel.simulation, words), part) > 0;
    });
  });
  return joined({joined(common), steplessText(motions, words)}, "; ");
}

/// Returns what a clock says of a speed other than 1: "  0.2×".
std::string speedMark(double speed, const scene::Words& words) {
  constexpr double kWhole = 100;  // From there on without decimals, and so without an exponent.
  const std::string text =
      speed < kWhole ? roundedText(speed, 3) : std::to_string(std::llround(speed));
  return text == "1" ? "" : fmt::format("  {}\u00d7", words.number(text));
}

/// Returns a black layer whose opacity rises smoothly from 0 at the top to kShade in `rise` rows.
Layer shade(int width, int height, int y, int rise) {
  Layer layer{0, y, width, height, {}};
  const auto rowSize = static_cast<std::size_t>(width) * 4;
  layer.pixels.resize(rowSize * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    const double t = std::min(1.0, (row + 0.5) / rise);
    const auto opacity = static_cast<std::uint8_t>(std::lround(255 * kShade * t * t * (3 - 2 * t)));
    std::uint8_t* pixels = layer.pixels.data() + static_cast<std::size_t>(row) * rowSize;
    for (std::size_t alpha = 3; alpha < rowSize; alpha += 4) pixels[alpha] = opacity;
  }
  return layer;
}

/// A text and its top on the picture. [pixels]
struct Line {
  Layer text;
  int top;
  bool isCaption = false;
};

/// Throws InputError if the text leaves too little of the picture for the book.
void refuseTooMany(const std::vector<Line>& lines, const scene::Scene& scene) {
  const int height = scene.clip.height, rows = height - lines.front().top;
  if (rows <= height / 2 || height < kSmallPicture) return;
  const auto tallest =
      std::ranges::max_element(lines, {}, [](const Line& line) { return line.text.height; });
  const char* key = tallest == lines.begin() ? "title" : "caption";
  throw InputError(
      fmt::format("{}: the text takes {} of the picture's {} rows, which leaves too little for the "
                  "book; shorten the {}, make the picture wider (clip.size) or the letters smaller "
                  "(overlay.scale), or leave \"caption\" out of overlay.show",
                  scene::locationOf(scene, key), rows, height, key));
}

}  // namespace

struct CaptionAndClock::Parts {
  Parts(const scene::Scene& asked, ClockPosition clockPosition)
      : scene(asked),
        position(clockPosition),
        scale(asked.clip.width, asked.clip.height, asked.overlay.scale),
        margin(static_cast<int>(std::lround(scale.margin))),
        type(Typesetter::of(asked)),
        captionStyle{.size = scale.letters, .colour = kWhite, .opacity = 0.95, .halo = scale.halo},
        clockStyle{.size = scale.letters,
                   .colour = kWhite,
                   .opacity = 0.92,
                   .halo = scale.halo,
                   .tabular = true},
        mirrored(shows(asked, scene::Overlay::Caption) &&
                 type.isReadFromTheRight(asked.title.empty() ? asked.caption : asked.title)) {
    const bool below = shows(scene, scene::Overlay::Clock) && position == ClockPosition::Bottom;
    if (shows(scene, scene::Overlay::Clock)) clock = clockBox();
    if (shows(scene, scene::Overlay::Caption) || shows(scene, scene::Overlay::Settings)) {
      setLines(below ? static_cast<int>(clock.width) + margin : 0);
    }
    if (below) {
      clock.x = mirrored ? margin : scale.width - margin - clock.width;
      clock.y = lines.empty() ? scale.height - margin - clock.height : lines.front().top;
    }
    if (!lines.empty()) {
      addShade(lines.front().top);
    } else if (below) {
      addShade(static_cast<int>(clock.y));
    }
  }

  /// Sets title, caption and settings, one below the other, down to the picture's lower margin;
  /// the first is `narrower` than the others. [pixels] A small picture goes without the last ones
  /// that would be in its upper half.
  void setLines(int narrower) {
    const int room = std::min(textWidth(), static_cast<int>(kLongestLine * scale.letters));
    const auto add = [&](std::string_view key, const std::string& text, const TextStyle& style) {
      if (text.empty()) return;
      const int width = lines.empty() ? std::min(room, textWidth() - narrower) : room;
      const auto draw = [&] { return type.draw(text, style, width); };
      lines.push_back({scene::atLocationOf(scene, key, draw), 0});
    };
    const double titleSize = std::max(kTitleSize * scale.unit, kSmallestTitle);
    const double settingsSize = std::max(kSettingsSize * scale.unit, kSmallestSettings);
    if (shows(scene, scene::Overlay::Caption)) {
      add("title", scene.title,
          {.size = titleSize, .bold = true, .colour = kWhite, .halo = scale.halo});
      addCaption(lines.empty() ? std::min(room, textWidth() - narrower) : room);
    }
    if (shows(scene, scene::Overlay::Settings)) {
      add("", settingsText(scene),
          {.size = settingsSize, .colour = kWhite, .opacity = 0.85, .halo = scale.halo});
    }

    placeLines();
    if (!lines.empty()) refuseTooMany(lines, scene);
    while (!lines.empty() && scale.height - lines.front().top > scale.height / 2) {
      lines.pop_back();
      placeLines();
    }
  }

  /// Adds the tallest of the clip's captions, each of which is `width` wide at most. [pixels]
  void addCaption(int width) {
    captionWidth = width;
    const int twoLines = type.measure("x\nx", captionStyle, width).height;
    Layer tallest;
    const auto take = [&](const std::string& key, const std::string& text) {
      if (text.empty()) return;
      Layer drawn =
          scene::atLocationOf(scene, key, [&] { return type.draw(text, captionStyle, width); });
      if (drawn.height > tallest.height) tallest = std::move(drawn);
    };
    if (&captionAt(scene, 0) == &scene.caption) take("caption", scene.caption);
    for (std::size_t i = 0; i < scene.cues.size(); ++i) {
      const std::string text = scene.cues[i].text.value_or("");
      take(scene::cueKey(i), text);
      if (type.measure(text, captionStyle, width).height > twoLines) longCues.push_back(i);
    }
    if (tallest.height > 0) lines.push_back({std::move(tallest), 0, true});
  }

  /// Puts the lines one below the other, the last at the lower margin.
  void placeLines() {
    const int gap = static_cast<int>(std::lround(0.45 * scale.letters));
    int bottom = scale.height - margin;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
      line->top = bottom - static_cast<int>(boxOf(line->text).height);
      bottom = line->top - gap;
    }
  }

  /// Leaves room for text from row `first` on, and adds a dark background unless the scene has
  /// none, the picture's has a colour to keep, or the text is below a grid.
  void addShade(int first) {
    const int top = std::max(0, first - margin / 2);
    bottomRows = std::min(scale.height - top, scale.height / 2);
    const bool isPlain = scene.look.background == scene::Background::Plain;
    if (!scene.overlay.band || isPlain || scene.grid) return;
    const int shadeTop = std::max(0, top - 5 * margin / 4);
    background = shade(scale.width, scale.height - shadeTop, shadeTop, std::max(1, top - shadeTop));
  }

  /// Draws the lines with that caption.
  CachedLayer written(const std::string& text) const {
    Canvas canvas(scale.width, scale.height, Ink(scene));
    const auto write = [&](const Layer& layer, int top) {
      const double left = mirrored ? scale.width - margin - boxOf(layer).width : margin;
      canvas.write(layer, {left, 1.0 * top});
    };
    for (const Line& line : lines) {
      if (!line.isCaption) {
        write(line.text, line.top);
      } else if (!text.empty()) {
        write(type.draw(text, captionStyle, captionWidth), line.top);
      }
    }
    return canvas.take();
  }

  /// Draws the lines as `frame` shows them, unless they are the same.
  bool setCaption(std::int64_t frame) {
    const std::string& text = captionAt(scene, frame);
    if (shownText == text) return false;
    caption = written(text);
    shownText = text;
    return true;
  }

  std::string timeAt(std::int64_t frame) const {
    const double time = scene::timeAt(scene, static_cast<double>(frame));
    return "t = " + clockText(time, scene.overlay.words) +
           speedMark(speedAt(scene, static_cast<double>(frame)), scene.overlay.words);
  }

  /// Returns a box at the top left that is wide enough for the last frame's time at each speed.
  Box clockBox() const {
    const scene::Words& words = scene.overlay.words;
    const auto frames = static_cast<double>(scene.clip.frameCount());
    const std::string time = "t = " + clockText(scene::timeAt(scene, frames), words);
    Box box{1.0 * margin, 1.0 * margin, 0, 0};
    for (const double speed : scene::speedsOf(scene)) {
      const TextSize size = type.measure(time + speedMark(speed, words), clockStyle, textWidth());
      box.width = std::max(box.width, 1.0 * size.width);
      box.height = std::max(box.height, 1.0 * size.height);
    }
    return box;
  }

  int textWidth() const { return scale.width - 2 * margin; }

  scene::Scene scene;
  ClockPosition position;
  Scale scale;
  int margin;  // [pixels]
  Typesetter type;
  TextStyle captionStyle, clockStyle;
  bool mirrored;     // The lines begin at the right, and the clock at the bottom is on the left.
  Layer background;  // below the text at the bottom
  std::vector<Line> lines;
  int captionWidth = 0;                  // at most [pixels]
  std::optional<std::string> shownText;  // what `caption` has been drawn with
  CachedLayer caption;                   // the lines
  std::vector<std::size_t> longCues;
  Box clock;  // empty if it isn't shown
  int bottomRows = 0;
  std::vector<Box> texts;
};

CaptionAndClock::CaptionAndClock(const scene::Scene& scene, ClockPosition position)
    : parts_(std::make_unique<Parts>(scene, position)) {}
CaptionAndClock::~CaptionAndClock() = default;

int CaptionAndClock::bottomRows() const {
  return parts_->bottomRows;
}

Box CaptionAndClock::corner() const {
  return parts_->position == ClockPosition::TopLeft ? parts_->clock : Box{};
}

const std::vector<std::size_t>& CaptionAndClock::longCues() const {
  return parts_->longCues;
}

void CaptionAndClock::draw(std::int64_t frame, std::int64_t clockFrame, image::Image& picture) {
  setCaption(frame);
  drawCaption(picture);
  drawClock(clockFrame, picture);
}

bool CaptionAndClock::setCaption(std::int64_t frame) {
  const bool isOther = parts_->setCaption(frame);
  parts_->texts = parts_->caption.texts;
  return isOther;
}

void CaptionAndClock::drawCaption(image::Image& picture) {
  for (const Layer* layer : {&parts_->background, &parts_->caption.layer})
    blendOverTouched(picture.area(), viewOf(*layer), picture);
}

void CaptionAndClock::drawClock(std::int64_t clockFrame, image::Image& picture) {
  if (parts_->clock.empty()) return;
  Layer clock =
      parts_->type.draw(parts_->timeAt(clockFrame), parts_->clockStyle, parts_->textWidth());
  parts_->texts.push_back(boxOf(clock, {parts_->clock.x, parts_->clock.y}));
  clock.x += static_cast<int>(parts_->clock.x);
  clock.y += static_cast<int>(parts_->clock.y);
  blend(clock, picture);
}

const std::vector<Box>& CaptionAndClock::texts() const {
  return parts_->texts;
}

}  // namespace rotatebook::overlay
