#include "overlay/ink.h"

#include <algorithm>
#include <cmath>

#include "base/rgb.h"

namespace rotatebook::overlay {
namespace {

// Contrasts as in WCAG 2.1: (lighter + 0.05) / (darker + 0.05).
constexpr double kFlare = 0.05;
constexpr double kContrast = 4.5;
// Black and white have equal contrasts, sqrt(1.05 * 0.05) - 0.05.
constexpr double kBright = 0.179;

double luminanceOf(const Colour& colour) {
  return rotatebook::luminanceOf(colour.red, colour.green, colour.blue);
}

}  // namespace

Ink::Ink(const scene::Scene& scene) {
  if (scene.look.background != scene::Background::Plain) return;
  const auto& [red, green, blue] = scene.look.plainColour;
  const double luminance = luminanceOf(Colour{red / 255.0, green / 255.0, blue / 255.0});
  if (luminance > kBright) luminance_ = luminance;
}

Colour Ink::operator()(const Colour& colour) const {
  if (!luminance_) return colour;
  // Mirror the lightness, the mean of the greatest and the least channel, which keeps the hue
  const double shift = 1 - std::max({colour.red, colour.green, colour.blue}) -
                       std::min({colour.red, colour.green, colour.blue});
  const Colour mirrored{colour.red + shift, colour.green + shift, colour.blue + shift};
  if (luminanceOf(colour) < kBright) return mirrored;
  const double most = std::max(0.0, (*luminance_ + kFlare) / kContrast - kFlare);
  const double scale = std::sqrt(std::min(1.0, most / luminanceOf(mirrored)));
  return {scale * mirrored.red, scale * mirrored.green, scale * mirrored.blue};
}

}  // namespace rotatebook::overlay
