#include "image/srgb.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "base/srgb.h"

namespace rotatebook::image {

const std::array<std::uint16_t, 256> kLinearOfSrgb = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<std::uint16_t>(
        std::lround(kMaxLinear * decodedSrgb(static_cast<double>(i) / 255)));
  }
  return table;
}();

const std::array<std::uint8_t, kMaxLinear + 1> kSrgbOfLinear = [] {
  std::array<std::uint8_t, kMaxLinear + 1> table{};
  std::size_t linear = 0;
  // The range of an sRGB value ends halfway to the next one, measured in sRGB.
  for (std::size_t i = 0; i < 255; ++i) {
    const double end = kMaxLinear * decodedSrgb((static_cast<double>(i) + 0.5) / 255);
    for (; static_cast<double>(linear) < end; ++linear)
      table[linear] = static_cast<std::uint8_t>(i);
  }
  for (; linear < table.size(); ++linear) table[linear] = 255;
  return table;
}();

}  // namespace rotatebook::image
