#include "overlay/layer.h"

#include <algorithm>
#include <cstddef>

namespace rotatebook::overlay {
namespace {

// value * factor / 255, rounded.
std::uint8_t scaled(std::uint8_t value, unsigned factor) {
  const unsigned product = value * factor + 128;
  return static_cast<std::uint8_t>((product + (product >> 8)) >> 8);
}

void blendPixel(const std::uint8_t* over, std::uint8_t* under, bool hasAlpha) {
  const unsigned left = 255U - over[3];
  if (left == 255) return;
  for (std::size_t i = 0; i < 3; ++i) {
    under[i] = static_cast<std::uint8_t>(over[2 - i] + scaled(under[i], left));
  }
  if (hasAlpha) under[3] = static_cast<std::uint8_t>(over[3] + scaled(under[3], left));
}

}  // namespace

void blend(const Layer& layer, image::Image& picture) {
  const int size = bytesPerPixel(picture.format());
  const int left = std::max(0, -layer.x);
  const int right = std::min(layer.width, picture.width() - layer.x);
  const int top = std::max(0, -layer.y);
  const int bottom = std::min(layer.height, picture.height() - layer.y);
  for (int y = top; y < bottom; ++y) {
    const std::uint8_t* over =
        layer.pixels.data() + (static_cast<std::ptrdiff_t>(y) * layer.width + left) * 4;
    std::uint8_t* under =
        picture.row(layer.y + y) + static_cast<std::ptrdiff_t>(layer.x + left) * size;
    for (int x = left; x < right; ++x, over += 4, under += size) {
      blendPixel(over, under, size == 4);
    }
  }
}

}  // namespace rotatebook::overlay
