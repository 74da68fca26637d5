// The alpha of a pixel that is read as one number.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace rotatebook::image {

/// The bits of alpha in a pixel of PixelFormat::Rgba8, or of a Layer, on any processor.
inline constexpr auto kAlphaMask =
    std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{0, 0, 0, 0xff});

}  // namespace rotatebook::image
