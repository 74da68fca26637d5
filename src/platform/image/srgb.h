// Conversion between sRGB and linear light (IEC 61966-2-1). Inside the room only.
#pragma once

#include <array>
#include <cstdint>

namespace rotatebook::image {

/// White in linear light, as an integer: the smallest step of sRGB is 20 of these.
inline constexpr std::uint32_t kMaxLinear = 65'535;

/// Lookup tables of the two functions below.
extern const std::array<std::uint16_t, 256> kLinearOfSrgb;
extern const std::array<std::uint8_t, kMaxLinear + 1> kSrgbOfLinear;

/// Returns the linear light of an sRGB value, 0 to kMaxLinear.
inline std::uint32_t linearFromSrgb(std::uint8_t encoded) {
  return kLinearOfSrgb[encoded];
}
/// Returns the sRGB value nearest to `linear`, 0 to kMaxLinear.
inline std::uint8_t srgbFromLinear(std::uint32_t linear) {
  return kSrgbOfLinear[linear];
}

}  // namespace rotatebook::image
