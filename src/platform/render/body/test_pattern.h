// The texture of test frames. Inside the room only.
#pragma once

#include <cstdint>

#include "image/image.h"

namespace rotatebook::render {

/// Returns a texture of which no two neighbours are alike.
inline image::Image testPattern() {
  constexpr int kSide = 64;
  image::Image picture(kSide, kSide, image::PixelFormat::Rgb8);
  for (int y = 0; y < kSide; ++y) {
    for (int i = 0; i < 3 * kSide; ++i)
      picture.row(y)[i] = static_cast<std::uint8_t>(37 * i + 101 * y + i * y);
  }
  return picture;
}

}  // namespace rotatebook::render
