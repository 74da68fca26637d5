// Writes JPEG files.
#pragma once

#include <string>

#include "image/image.h"

namespace rotatebook::image {

/// Returns a picture as JPEG, with losses: `quality` is 1 to 100. Alpha is left out. The bytes are
/// the same on every machine. Throws MachineError if libjpeg can't encode it.
std::string jpegText(ImageView picture, int quality);

}  // namespace rotatebook::image
