// The orientation of photographs. Inside the room only.
#pragma once

#include <cstdint>
#include <span>

#include "image/image.h"

namespace rotatebook::image {

/// Returns the orientation that EXIF states, 1 to 8 (CIPA DC-008, tag 0x0112): 1, upright, if it
/// states none or is damaged. `exif` is a TIFF, with or without "Exif\0\0" before it.
int orientationOf(std::span<const std::uint8_t> exif);

/// Returns the picture upright that is stored with `orientation`, 1 to 8.
Image upright(Image stored, int orientation);

}  // namespace rotatebook::image
