#include "plot/map_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rotatebook::plot {
namespace {

using scene::Outcome;

/// Equidistant colours of a palette, 0xrrggbb; those between them are interpolated.
using Colours = std::array<std::uint32_t, 33>;

// Of matplotlib, by van der Walt and Smith (2015), under CC0. Within 2 of 255 of its 256 colours.
constexpr Colours kInferno{0x000004, 0x040312, 0x0b0724, 0x150b37, 0x210c4a, 0x2e0a5a, 0x3c0965,
                           0x4a0c6b, 0x57106d, 0x63146e, 0x70196e, 0x7d1e6d, 0x89226a, 0x962766,
                           0xa32b61, 0xaf315c, 0xbb3755, 0xc63e4d, 0xd14644, 0xdb4f3b, 0xe35932,
                           0xeb6528, 0xf1711e, 0xf67f14, 0xf98d0a, 0xfb9c06, 0xfcab0f, 0xfbba1f,
                           0xf9ca32, 0xf5d949, 0xf2e865, 0xf3f586, 0xfcffa4};
constexpr Colours kViridis{0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453681, 0x424086,
                           0x3f4989, 0x3b528b, 0x375a8d, 0x33638d, 0x2f6a8e, 0x2c728e, 0x297a8e,
                           0x26818e, 0x23898e, 0x21908c, 0x1f988b, 0x1f9f88, 0x21a685, 0x28ae80,
                           0x31b57b, 0x3ebc74, 0x4cc26c, 0x5dc963, 0x6ece58, 0x82d34c, 0x96d83f,
                           0xabdc32, 0xc0df24, 0xd5e21a, 0xeae51a, 0xfde725};
// Moreland, Diverging Color Maps for Scientific Visualization (2009), by its formula.
constexpr Colours kCoolwarm{0x3b4cc0, 0x445acc, 0x4d68d7, 0x5775e1, 0x6282ea, 0x6c8ef1, 0x779af7,
                            0x82a5fb, 0x8db0fe, 0x98b9ff, 0xa3c2fe, 0xaec9fc, 0xb8d0f9, 0xc2d5f4,
                            0xccd9ee, 0xd5dbe6, 0xdddddd, 0xe5d8d1, 0xecd3c5, 0xf1ccb9, 0xf4c4ad,
                            0xf7bba0, 0xf7b194, 0xf7a687, 0xf49a7b, 0xf18d6f, 0xec7f63, 0xe57058,
                            0xde604d, 0xd55042, 0xcb3e38, 0xc0282f, 0xb40426};

Rgb colourAmong(const Colours& colours, double share) {
  const double place = share * static_cast<double>(colours.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  const auto channel = [&](int shift) {
    const auto value = [&](std::size_t i) { return 1.0 * ((colours[i] >> shift) & 0xff); };
    return static_cast<std::uint8_t>(
        std::lround(std::lerp(value(first), value(first + 1), place - static_cast<double>(first))));
  };
  return {channel(16), channel(8), channel(0)};
}

}  // namespace

Rgb colourAt(scene::Palette palette, double share) {
  const double place = std::clamp(share, 0.0, 1.0);
  switch (palette) {
    case scene::Palette::Inferno:
      return colourAmong(kInferno, place);
    case scene::Palette::Viridis:
      return colourAmong(kViridis, place);
    case scene::Palette::Coolwarm:
      return colourAmong(kCoolwarm, place);
    case scene::Palette::Gray:
      break;
  }
  const auto level = static_cast<std::uint8_t>(std::lround(255 * place));
  return {level, level, level};
}

MapColouring::MapColouring(const scene::MapColours& settings, const study::MapFacts& facts)
    : settings_(settings),
      from_(settings.from.value_or(facts.withValue() > 0 ? facts.smallest : 0)),
      to_(settings.to.value_or(facts.withValue() > 0 ? facts.largest : 1)) {
  constexpr double kDecades = 1e12;  // that a logarithmic scale has where values reach 0
  const bool isLogarithmic = settings_.scale == scene::Scale::Logarithmic;
  if (isLogarithmic && !(to_ > 0)) to_ = 1;
  if (isLogarithmic && !(from_ > 0)) from_ = to_ / kDecades;
  if (!(from_ < to_)) to_ = from_ + (from_ == 0 ? 1 : std::fabs(from_));
}

double MapColouring::shareOf(double value) const {
  if (settings_.scale == scene::Scale::Logarithmic && !(value > 0)) return 0;
  return scene::shareOf(value, from_, to_, settings_.scale);
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
  return at(shareOf(value));
}

void putColour(const Rgb& colour, std::uint8_t* bytes) {
  bytes[0] = colour.red;
  bytes[1] = colour.green;
  bytes[2] = colour.blue;
}

image::Image mapPixels(const std::vector<double>& values, const scene::MapSettings& map,
                       const MapColouring& colouring, int stride) {
  image::Image picture((map.width + stride - 1) / stride, (map.height + stride - 1) / stride,
                       image::PixelFormat::Rgb8);
  for (int y = 0; y < picture.height(); ++y) {
    const auto row = static_cast<std::size_t>(picture.height() - 1 - y) *
                     static_cast<std::size_t>(stride) * static_cast<std::size_t>(map.width);
    double coloured = values[row];
    Rgb colour = colouring.of(coloured);
    for (int x = 0; x < picture.width(); ++x) {
      const double value = values[row + static_cast<std::size_t>(x * stride)];
      if (value != coloured) colour = colouring.of(coloured = value);  // Many neighbours are equal.
      putColour(colour, picture.row(y) + 3 * static_cast<std::ptrdiff_t>(x));
    }
  }
  return picture;
}

image::Image plainMap(const study::MapResult& result, const scene::MapSettings& map) {
  const MapColouring colouring(map.colours, factsOf(result));
  image::Image picture(map.width * static_cast<int>(result.values.size()), map.height,
                       image::PixelFormat::Rgb8);
  for (std::size_t panel = 0; panel < result.values.size(); ++panel) {
    paste(mapPixels(result.values[panel], map, colouring, 1).view(),
          static_cast<int>(panel) * map.width, 0, picture);
  }
  return picture;
}

}  // namespace rotatebook::plot
