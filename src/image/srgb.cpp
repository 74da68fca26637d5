#include "image/srgb.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

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

std::uint32_t lightFromSrgb(std::uint8_t encoded) {
  static const std::array<std::uint16_t, 256> table = [] {
    std::array<std::uint16_t, 256> values{};
    for (std::size_t i = 0; i < 256; ++i) {
      values[i] = static_cast<std::uint16_t>(
          std::lround(kFullLight * linearFromSrgb(static_cast<std::uint8_t>(i))));
    }
    return values;
  }();
  return table[encoded];
}

std::uint8_t srgbFromLight(std::uint32_t light) {
  static const std::vector<std::uint8_t> table = [] {
    std::vector<std::uint8_t> values;
    for (std::uint32_t i = 0; i <= kFullLight; ++i) {
      values.push_back(srgbFromLinear(static_cast<double>(i) / kFullLight));
    }
    return values;
  }();
  return table[light];
}

}  // namespace rotatebook::image
