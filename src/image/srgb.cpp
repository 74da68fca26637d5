#include "image/srgb.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace rotatebook::image {
namespace {

double decoded(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

double linearFromSrgb(std::uint8_t encoded) {
  static const std::array<double, 256> table = [] {
    std::array<double, 256> values{};
    for (std::size_t i = 0; i < 256; ++i) values[i] = decoded(static_cast<double>(i) / 255);
    return values;
  }();
  return table[encoded];
}

std::uint8_t srgbFromLinear(double light) {
  const double value =
      light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * value));
}

}  // namespace rotatebook::image
