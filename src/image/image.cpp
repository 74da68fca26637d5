#include "image/image.h"

#include <cassert>

namespace rotatebook::image {

Image::Image(int width, int height, PixelFormat format)
    : width_(width), height_(height), format_(format) {
  assert(width > 0 && height > 0);
  bytes_.resize(static_cast<std::size_t>(stride()) * static_cast<std::size_t>(height));
}

}  // namespace rotatebook::image
