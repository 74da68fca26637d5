// Between sRGB's numbers and light (IEC 61966-2-1). Inside the room only.
#pragma once

#include <array>
#include <cstdint>

namespace rotatebook::image {

/// White, where light is a whole number: as fine as sRGB is where that is finest.
inline constexpr std::uint32_t kFullLight = 65'535;

/// What the two functions below look up.
extern const std::array<std::uint16_t, 256> kLightOfSrgb;
extern const std::array<std::uint8_t, kFullLight + 1> kSrgbOfLight;

/// The light of an sRGB number, 0 to kFullLight.
inline std::uint32_t lightFromSrgb(std::uint8_t encoded) {
  return kLightOfSrgb[encoded];
}
/// The sRGB number nearest to `light`, 0 to kFullLight.
inline std::uint8_t srgbFromLight(std::uint32_t light) {
  return kSrgbOfLight[light];
}

}  // namespace rotatebook::image
