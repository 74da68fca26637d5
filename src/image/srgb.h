// Between sRGB's numbers and light (IEC 61966-2-1).
#pragma once

#include <cstdint>

namespace rotatebook::image {

/// The light of an sRGB number, 0 to 1.
double linearFromSrgb(std::uint8_t encoded);
/// The sRGB number nearest to `light`, 0 to 1.
std::uint8_t srgbFromLinear(double light);

/// White, where light is a whole number: as fine as sRGB is where that is finest.
inline constexpr std::uint32_t kFullLight = 65'535;
/// The light of an sRGB number, 0 to kFullLight. Looked up.
std::uint32_t lightFromSrgb(std::uint8_t encoded);
/// The sRGB number nearest to `light`, 0 to kFullLight. Looked up.
std::uint8_t srgbFromLight(std::uint32_t light);

}  // namespace rotatebook::image
