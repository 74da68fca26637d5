#include "picture/map_colours.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Core>
#include <Eigen/LU>

#include "base/srgb.h"

namespace rotatebook::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using scene::Outcome;

// The chosen colours, from the darkest to the lightest.
constexpr std::array<Rgb, 8> kEmber{{{9, 9, 32},
                                     {39, 22, 96},
                                     {104, 30, 124},
                                     {172, 44, 106},
                                     {226, 82, 62},
                                     {248, 143, 55},
                                     {252, 205, 98},
                                     {255, 251, 224}}};
constexpr std::array<Rgb, 7> kLagoon{{{24, 10, 48},
                                      {50, 42, 112},
                                      {39, 88, 142},
                                      {31, 138, 140},
                                      {62, 181, 115},
                                      {164, 214, 88},
                                      {250, 243, 166}}};
constexpr std::array<Rgb, 2> kSlate{{{10, 10, 12}, {250, 250, 248}}};

std::span<const Rgb> chosenOf(scene::Palette palette) {
  if (palette == scene::Palette::Ember) return kEmber;
  if (palette == scene::Palette::Lagoon) return kLagoon;
  return kSlate;
}

// Oklab's two matrices. (https://bottosson.github.io/posts/oklab)
Matrix3d coneFromLight() {
  return (Matrix3d() << 0.4122214708, 0.5363325363, 0.0514459929,  //
          0.2119034982, 0.6806995451, 0.1073969566,                //
          0.0883024619, 0.2817188376, 0.6299787005)
      .finished();
}

Matrix3d labFromCone() {
  return (Matrix3d() << 0.2104542553, 0.7936177850, -0.0040720468,  //
          1.9779984951, -2.4285922050, 0.4505937099,                //
          0.0259040371, 0.7827717662, -0.8086757660)
      .finished();
}

Vector3d labOf(const Rgb& colour) {
  const Vector3d light(decodedSrgb(colour.red / 255.0), decodedSrgb(colour.green / 255.0),
                       decodedSrgb(colour.blue / 255.0));
  const Vector3d cone = coneFromLight() * light;
  return labFromCone() * Vector3d(std::cbrt(cone.x()), std::cbrt(cone.y()), std::cbrt(cone.z()));
}

Rgb rgbOf(const Vector3d& lab) {
  const Vector3d root = labFromCone().inverse() * lab;
  const Vector3d light = coneFromLight().inverse() * root.array().cube().matrix();
  const auto channel = [](double value) {
    return static_cast<std::uint8_t>(std::lround(255 * encodedSrgb(std::clamp(value, 0.0, 1.0))));
  };
  return {channel(light.x()), channel(light.y()), channel(light.z())};
}

/// Returns the point at `share` of the length of the line through `points`.
Vector3d pointAlong(const std::vector<Vector3d>& points, double share) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  double left = share * length;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double piece = (points[i] - points[i - 1]).norm();
    if (left <= piece || i + 1 == points.size()) {
      return points[i - 1] + std::min(left / piece, 1.0) * (points[i] - points[i - 1]);
    }
    left -= piece;
  }
  return points.front();
}

}  // namespace

PaletteColours::PaletteColours(scene::Palette palette, bool isReversed) {
  std::vector<Vector3d> points;
  for (const Rgb& colour : chosenOf(palette)) points.push_back(labOf(colour));
  for (std::size_t i = 0; i < kCount; ++i) {
    const double share = static_cast<double>(i) / (kCount - 1);
    colours_[isReversed ? kCount - 1 - i : i] = rgbOf(pointAlong(points, share));
  }
}

Rgb PaletteColours::at(double share) const {
  const double place = std::clamp(share, 0.0, 1.0) * (kCount - 1);
  return colours_[static_cast<std::size_t>(std::lround(place))];
}

MapColouring::MapColouring(const scene::MapColours& settings, const study::MapFacts& facts)
    : palette_(settings.palette, settings.reversed),
      scale_(settings.scale),
      from_(settings.from.value_or(facts.withValue() > 0 ? facts.smallest : 0)),
      to_(settings.to.value_or(facts.withValue() > 0 ? facts.largest : 1)) {
  constexpr double kDecades = 1e12;  // that a logarithmic scale has where values reach 0
  const bool isLogarithmic = scale_ == scene::Scale::Logarithmic;
  if (isLogarithmic && !(to_ > 0)) to_ = 1;
  if (isLogarithmic && !(from_ > 0)) from_ = to_ / kDecades;
  if (!(from_ < to_)) to_ = from_ + (from_ == 0 ? 1 : std::fabs(from_));
}

double MapColouring::shareOf(double value) const {
  if (scale_ == scene::Scale::Logarithmic && !(value > 0)) return 0;
  return scene::shareOf(value, from_, to_, scale_);
}

Rgb MapColouring::of(double value) const {
  switch (study::outcomeOf(value)) {
    case Outcome::Never:
      return kNeverColour;
    case Outcome::Diverged:
      return kDivergedColour;
    case Outcome::Refused:
      return kRefusedColour;
    case Outcome::Value:
      break;
  }
  return palette_.at(shareOf(value));
}

image::Image plainMap(const study::MapResult& result, const scene::MapSettings& map) {
  const MapColouring colouring(map.colours, factsOf(result));
  const auto panels = static_cast<int>(result.values.size());
  image::Image picture(map.width * panels, map.height, image::PixelFormat::Rgb8);
  for (int y = 0; y < map.height; ++y) {
    std::uint8_t* byte = picture.row(y);
    for (const std::vector<double>& values : result.values) {
      const auto row =
          static_cast<std::size_t>(map.height - 1 - y) * static_cast<std::size_t>(map.width);
      for (std::size_t x = 0; x < static_cast<std::size_t>(map.width); ++x) {
        const Rgb colour = colouring.of(values[row + x]);
        *byte++ = colour.red;
        *byte++ = colour.green;
        *byte++ = colour.blue;
      }
    }
  }
  return picture;
}

}  // namespace rotatebook::picture
