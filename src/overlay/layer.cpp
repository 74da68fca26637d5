#include "overlay/layer.h"

#include <algorithm>
#include <cstring>

namespace rotatebook::overlay {
namespace {

// Two bytes in a 32-bit number, 16 bits apart.
constexpr std::uint32_t kPair = 0x00ff00ff;

/// Each byte of the pair `values` times factor / 255, rounded.
std::uint32_t scaledPair(std::uint32_t values, std::uint32_t factor) {
  const std::uint32_t product = values * factor + 0x00800080;
  return ((product + ((product >> 8) & kPair)) >> 8) & kPair;
}

std::uint8_t scaled(std::uint32_t value, std::uint32_t factor) {
  return static_cast<std::uint8_t>(scaledPair(value, factor));
}

/// A row over one without transparency: two colours at a time, several pixels at once.
void blendRowOverOpaque(const std::uint8_t* over, std::uint8_t* under, int count) {
  for (int i = 0; i < count; ++i) {
    std::uint32_t top = 0, bottom = 0;
    std::memcpy(&top, over + 4 * i, 4);
    std::memcpy(&bottom, under + 4 * i, 4);
    const std::uint32_t left = 255 - (top >> 24);
    const std::uint32_t redBlue = ((top >> 16) & 0xff) | ((top & 0xff) << 16);
    const std::uint32_t greenAlpha = (top >> 8) & kPair;
    const std::uint32_t sum = (redBlue + scaledPair(bottom & kPair, left)) |
                              ((greenAlpha + scaledPair((bottom >> 8) & kPair, left)) << 8);
    std::memcpy(under + 4 * i, &sum, 4);
  }
}

/// Over straight alpha, whose colours must be taken by their share.
void blendOverClear(const std::uint8_t* over, std::uint8_t* under) {
  const std::uint32_t share = scaled(under[3], 255U - over[3]);
  const std::uint32_t alpha = over[3] + share;
  if (alpha == 0) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t sum = 255U * over[2 - i] + share * under[i];
    under[i] = static_cast<std::uint8_t>(std::min(255U, (sum + alpha / 2) / alpha));
  }
  under[3] = static_cast<std::uint8_t>(alpha);
}

void blendRowOverRgba(const std::uint8_t* over, std::uint8_t* under, int count) {
  std::uint8_t least = 255;
  for (int i = 0; i < count; ++i) least &= under[4 * i + 3];
  if (least == 255) return blendRowOverOpaque(over, under, count);
  for (int i = 0; i < count; ++i) {
    if (over[4 * i + 3] > 0) blendOverClear(over + 4 * i, under + 4 * i);
  }
}

void blendRowOverRgb(const std::uint8_t* over, std::uint8_t* under, int count) {
  for (int i = 0; i < count; ++i, over += 4, under += 3) {
    const std::uint32_t left = 255U - over[3];
    if (left == 255) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      under[c] = static_cast<std::uint8_t>(over[2 - c] + scaled(under[c], left));
    }
  }
}

/// The first pixel from `from` on that is covered, or isn't.
int nextPixel(const std::uint8_t* row, int from, int end, bool covered) {
  while (from < end && (row[4 * from + 3] > 0) != covered) ++from;
  return from;
}

/// Calls `blendRow` for each run of pixels that aren't transparent.
template <typename BlendRow>
void blendRuns(const std::uint8_t* over, std::uint8_t* under, int count, int size,
               const BlendRow& blendRow) {
  for (int first = nextPixel(over, 0, count, true); first < count;) {
    const int end = nextPixel(over, first, count, false);
    blendRow(over + 4 * static_cast<std::ptrdiff_t>(first),
             under + size * static_cast<std::ptrdiff_t>(first), end - first);
    first = nextPixel(over, end, count, true);
  }
}

}  // namespace

LayerView viewOf(const Layer& layer) {
  return {layer.x,
          layer.y,
          layer.width,
          layer.height,
          layer.pixels.data(),
          static_cast<std::ptrdiff_t>(layer.width) * 4};
}

void blend(const LayerView& layer, image::Image& picture) {
  const int size = bytesPerPixel(picture.format());
  const int left = std::max(0, -layer.x);
  const int right = std::min(layer.width, picture.width() - layer.x);
  const int top = std::max(0, -layer.y);
  const int bottom = std::min(layer.height, picture.height() - layer.y);
  if (left >= right) return;
  const auto blendRow = size == 4 ? &blendRowOverRgba : &blendRowOverRgb;
  for (int y = top; y < bottom; ++y) {
    blendRuns(layer.pixels + y * layer.stride + static_cast<std::ptrdiff_t>(left) * 4,
              picture.row(layer.y + y) + static_cast<std::ptrdiff_t>(layer.x + left) * size,
              right - left, size, blendRow);
  }
}

}  // namespace rotatebook::overlay
