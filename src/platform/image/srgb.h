// Between sRGB's numbers and light (IEC 61966-2-1). Inside the room only.
#pragma once

#include <array>
#include <cstdint>

namespace rotatebook::image {

/// White, where light is a whole number: as fine as sRGB is where that is finest.
inline constexpr std::uint32_t kMaxLinear = 65'535;

/// What the two functions below look up.
extern const std::array<std::uint16_t, 256> kLinearOfSrgb;
extern const std::array<std::uint8_t, kMaxLinear + 1> kSrgbOfLinear;

/// The light of an sRGB number, 0 to kMaxLinear.
inline std::uint32_t linearFromSrgb(std::uint8_t encoded) {
  return kLinearOfSrgb[encoded];
}
/// The sRGB number nearest to `light`, 0 to kMaxLinear.
inline std::uint8_t srgbFromLinear(std::uint32_t light) {
  return kSrgbOfLinear[light];
}

}  // namespace rotatebook::image
