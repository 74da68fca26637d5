#include "image/image.h"

#include <algorithm>
#include <cassert>

namespace rotatebook::image {

Image::Image(int width, int height, PixelFormat format)
    : width_(width), height_(height), format_(format) {
  assert(width > 0 && height > 0);
  bytes_.resize(static_cast<std::size_t>(stride()) * static_cast<std::size_t>(height));
}

void paste(const ImageView& piece, int x, int y, Image& picture) {
  assert(piece.format == picture.format() && x >= 0 && y >= 0);
  assert(x + piece.width <= picture.width() && y + piece.height <= picture.height());
  const std::ptrdiff_t size = bytesPerPixel(piece.format);
  for (int row = 0; row < piece.height; ++row) {
    std::copy_n(piece.row(row), piece.width * size, picture.row(y + row) + x * size);
  }
}

}  // namespace rotatebook::image
