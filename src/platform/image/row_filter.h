// Filters the rows of a PNG. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>

#include "image/image.h"

namespace rotatebook::image {

/// Number of bytes that filterRow() may write past its row, for the next row to overwrite.
inline constexpr std::size_t kFilterOverrun = 8;

/// Returns the size of a filtered row. [bytes]
std::size_t filteredRowSize(const ImageView& view, bool alpha);

/// Writes row `y` as a PNG stores it: the number of the filter Sub, then the pixels, RGB or if
/// `alpha` RGBA, minus those to their left. Returns where the next row goes.
std::uint8_t* filterRow(const ImageView& view, int y, bool alpha, std::uint8_t* out);

}  // namespace rotatebook::image
