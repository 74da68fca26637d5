#include "overlay/overlays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "overlay/layer.h"
#include "overlay/text.h"
#include "scene/names.h"

namespace rotatebook::overlay {
namespace {

// Of the picture's height, but never so small that letters can't be read.
constexpr double kTitleSize = 0.036, kSmallestTitle = 13;
constexpr double kCaptionSize = 0.0255, kSmallestCaption = 10;
constexpr double kSettingsSize = 0.0215, kSmallestSettings = 9;
constexpr double kMargin = 0.045;
// A line longer than this many letter heights is hard to follow.
constexpr double kLongestLine = 56;
constexpr double kShade = 0.5;  // how dark the ground of the words gets

constexpr Colour kWhite{0.97, 0.96, 0.93};
constexpr Colour kGrey{0.72, 0.72, 0.74};

/// The lengths that follow from the picture's size. [pixels]
struct Scale {
  explicit Scale(const scene::ClipSettings& clip)
      : width(clip.width),
        height(clip.height),
        margin(static_cast<int>(std::lround(kMargin * height))),
        room(width - 2 * margin) {}

  double size(double share, double least) const { return std::max(share * height, least); }

  int width;
  int height;
  int margin;
  int room;  // between the margins
};

bool shows(const scene::Scene& scene, scene::Overlay overlay) {
  return std::ranges::count(scene.overlay.show, overlay) > 0;
}

Typesetter typesetterFor(const std::string& font) {
  return font == scene::kBuiltin ? Typesetter() : Typesetter(font);
}

/// How the motion was simulated: "quaternion, rk4, normalised, h = 0.26 ms".
std::string settingsText(const physics::SimulationSettings& settings) {
  std::string text(nameOf(scene::kModels, settings.model));
  if (settings.model == physics::Model::Exact) return text + " solution";
  text += ", " + std::string(nameOf(scene::kIntegrators, settings.integrator));
  text += settings.normalize ? ", normalised" : ", not normalised";
  if (settings.model == physics::Model::Particles) {
    text += settings.damping > 0 ? ", damping " + shortestText(settings.damping) : ", undamped";
    text += ", k = " + shortestText(settings.stiffness) + " N/m";
  }
  return text + ", step " + roundedText(1e3 * settings.timePerFrame / settings.substeps, 3) + " ms";
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

/// Title, caption and settings, one below the other, the last above the picture's lower margin.
std::vector<Layer> captionLines(const Typesetter& type, const scene::Scene& scene) {
  const Scale scale(scene.clip);
  const double captionSize = scale.size(kCaptionSize, kSmallestCaption);
  const int room = std::min(scale.room, static_cast<int>(kLongestLine * captionSize));
  std::vector<Layer> lines;
  const auto add = [&](const std::string& text, const TextStyle& style) {
    if (!text.empty()) lines.push_back(type.draw(text, style, room));
  };
  add(scene.title, {scale.size(kTitleSize, kSmallestTitle), true, kWhite, 1});
  add(scene.caption, {captionSize, false, kWhite, 0.92});
  add(settingsText(scene.simulation),
      {scale.size(kSettingsSize, kSmallestSettings), false, kGrey, 1});

  const int gap = static_cast<int>(std::lround(0.45 * captionSize));
  int bottom = scale.height - scale.margin;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    line->x = scale.margin;
    line->y = bottom - line->height;
    bottom = line->y - gap;
  }
  return lines;
}

std::string clockText(double time) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "t = %.2f s", time);
  return text.data();
}

}  // namespace

struct Overlays::Parts {
  explicit Parts(const scene::Scene& asked)
      : scene(asked), scale(asked.clip), type(typesetterFor(asked.overlay.font)) {
    if (!shows(scene, scene::Overlay::Caption)) return;
    still = captionLines(type, scene);
    const int top = std::max(0, still.front().y - scale.margin / 2);
    bottomRows = std::min(scale.height - top, scale.height / 2);
    const int shadeTop = std::max(0, top - scale.margin);
    still.insert(still.begin(), shade(scale.width, scale.height - shadeTop, shadeTop));
  }

  scene::Scene scene;
  Scale scale;
  Typesetter type;
  std::vector<Layer> still;  // what is the same in every frame, the lowest first
  int bottomRows = 0;
};

Overlays::Overlays(const scene::Scene& scene) : parts_(std::make_unique<Parts>(scene)) {}
Overlays::~Overlays() = default;
Overlays::Overlays(Overlays&&) noexcept = default;
Overlays& Overlays::operator=(Overlays&&) noexcept = default;

int Overlays::bottomRows() const {
  return parts_->bottomRows;
}

void Overlays::draw(std::int64_t frame, image::Image& picture) {
  for (const Layer& layer : parts_->still) blend(layer, picture);
  if (!shows(parts_->scene, scene::Overlay::Clock)) return;
  const Scale& scale = parts_->scale;
  const double time = static_cast<double>(frame) * parts_->scene.simulation.timePerFrame;
  const TextStyle style{scale.size(kCaptionSize, kSmallestCaption), false, kWhite, 0.92};
  Layer clock = parts_->type.draw(clockText(time), style, scale.room);
  clock.x = clock.y = scale.margin;
  blend(clock, picture);
}

}  // namespace rotatebook::overlay
