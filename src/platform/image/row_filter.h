// The filter of a PNG's rows. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>

#include "image/image.h"

namespace rotatebook::image {

/// Bytes that the filter may write behind a row, to be written over.
inline constexpr std::size_t kFilterOverrun = 8;

/// Bytes of a filtered row.
std::size_t filteredRowSize(const ImageView& view, bool alpha);

/// Writes row `y` as PNG has it: the number of the filter Up, then the pixels, RGB or with their
/// `alpha` RGBA, minus those of the row above. Returns where the next row goes.
std::uint8_t* filterRow(const ImageView& view, int y, bool alpha, std::uint8_t* out);

}  // namespace rotatebook::image
