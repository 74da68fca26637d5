// Filters the rows of a PNG. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>

#include "image/image.h"

namespace rotatebook::image {

/// The filter with which rows are stored: PNG specification, section 9.2.
inline constexpr std::uint8_t kFilterSub = 1;

/// Number of bytes that filterPixels() may write past its pixels.
inline constexpr std::size_t kFilterOverrun = 8;

/// Writes `count` pixels of row `y` from `left` on as a PNG stores them: RGB or if `alpha` RGBA,
/// minus those to their left.
void filterPixels(const ImageView& view, int y, int left, int count, bool alpha, std::uint8_t* out);

}  // namespace rotatebook::image
