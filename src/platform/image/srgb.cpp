#include "image/srgb.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace rotatebook::image {
namespace {

/// The light of a number from 0 to 1.
double decoded(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

const std::array<std::uint16_t, 256> kLinearOfSrgb = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] =
        static_cast<std::uint16_t>(std::lround(kMaxLinear * decoded(static_cast<double>(i) / 255)));
  }
  return table;
}();

const std::array<std::uint8_t, kMaxLinear + 1> kSrgbOfLinear = [] {
  std::array<std::uint8_t, kMaxLinear + 1> table{};
  std::size_t light = 0;
  // Each number's light ends halfway, as sRGB counts, to the next one's.
  for (std::size_t i = 0; i < 255; ++i) {
    const double end = kMaxLinear * decoded((static_cast<double>(i) + 0.5) / 255);
    for (; static_cast<double>(light) < end; ++light) table[light] = static_cast<std::uint8_t>(i);
  }
  for (; light < table.size(); ++light) table[light] = 255;
  return table;
}();

}  // namespace rotatebook::image
