// Writes WebP files.
#pragma once

#include <string>

#include "image/image.h"

namespace rotatebook::image {

/// Returns an Rgb8 or Rgba8 picture as WebP, with losses: `quality` is 0 to 100. Alpha is kept.
/// Throws MachineError if libwebp can't encode it.
std::string webpText(ImageView picture, float quality);

}  // namespace rotatebook::image
