// Round numbers for scales and legends. Inside the room only.
#pragma once

#include <cmath>

namespace rotatebook::overlay {

/// Rounds `value` > 0 up to 1, 2 or 5 times a power of ten.
inline double roundedUp(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (value <= digit * power * (1 + 1e-9)) return digit * power;
  }
  return 10 * power;
}

/// Rounds `value` > 0 down likewise.
inline double roundedDown(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0}) {
    if (value >= digit * power * (1 - 1e-9)) return digit * power;
  }
  return power;
}

}  // namespace rotatebook::overlay
