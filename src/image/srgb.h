// Between sRGB's numbers and light (IEC 61966-2-1).
#pragma once

#include <cstdint>

namespace rotatebook::image {

/// The light of an sRGB number, 0 to 1.
double linearFromSrgb(std::uint8_t encoded);
/// The sRGB number nearest to `light`, 0 to 1.
std::uint8_t srgbFromLinear(double light);

}  // namespace rotatebook::image
