// sRGB's formula (IEC 61966-2-1), for what tests expect of the tables.
#pragma once

#include <cmath>
#include <cstdint>

namespace rotatebook::image {

/// The light of an sRGB number, 0 to 1.
inline double linearByFormula(std::uint8_t encoded) {
  const double value = encoded / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The sRGB number nearest to `light`, 0 to 1.
inline std::uint8_t srgbFromLinear(double light) {
  const double value =
      light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * value));
}

}  // namespace rotatebook::image
