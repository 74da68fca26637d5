#include "image/layer.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace rotatebook::image {
namespace {

// Two pixels as bytes, and as wider numbers: one instruction computes with all eight channels.
using Bytes [[gnu::vector_size(8)]] = std::uint8_t;
using Numbers [[gnu::vector_size(16)]] = std::uint16_t;

/// Returns value * factor / 255, rounded.
template <typename Number>
Number scaled(Number value, Number factor) {
  const Number product = value * factor + 128;
  return (product + (product >> 8)) >> 8;
}

Numbers load(const std::uint8_t* twoPixels) {
  Bytes bytes;
  std::memcpy(&bytes, twoPixels, sizeof bytes);
  return __builtin_convertvector(bytes, Numbers);
}

/// Blends two pixels over two opaque ones.
void blendTwoOverOpaque(const std::uint8_t* over, std::uint8_t* under) {
  const Numbers top = load(over);
  const Numbers left = 255 - __builtin_shufflevector(top, top, 3, 3, 3, 3, 7, 7, 7, 7);
  const Numbers redFirst = __builtin_shufflevector(top, top, 2, 1, 0, 3, 6, 5, 4, 7);
  const Bytes sum = __builtin_convertvector(redFirst + scaled(load(under), left), Bytes);
  std::memcpy(under, &sum, sizeof sum);
}

void blendRowOverOpaque(const std::uint8_t* over, std::uint8_t* under, int count) {
  for (; count >= 2; count -= 2, over += 8, under += 8) blendTwoOverOpaque(over, under);
  if (count == 0) return;
  std::array<std::uint8_t, 8> top{}, bottom{};
  std::memcpy(top.data(), over, 4);
  std::memcpy(bottom.data(), under, 4);
  blendTwoOverOpaque(top.data(), bottom.data());
  std::memcpy(under, bottom.data(), 4);
}

/// Blends a pixel over one with straight alpha: both colours are weighted by their share of the
/// sum.
void blendOverClear(const std::uint8_t* over, std::uint8_t* under) {
  const std::uint32_t share = scaled<std::uint32_t>(under[3], 255U - over[3]);
  const std::uint32_t alpha = over[3] + share;
  if (alpha == 0) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t sum = 255U * over[2 - i] + share * under[i];
    under[i] = static_cast<std::uint8_t>(std::min(255U, (sum + alpha / 2) / alpha));
  }
  under[3] = static_cast<std::uint8_t>(alpha);
}

void blendRowOverRgba(const std::uint8_t* over, std::uint8_t* under, int count) {
  std::uint8_t alphas = 255;
  for (int i = 0; i < count; ++i) alphas &= under[4 * i + 3];
  if (alphas == 255) return blendRowOverOpaque(over, under, count);
  for (int i = 0; i < count; ++i) {
    if (over[4 * i + 3] > 0) blendOverClear(over + 4 * i, under + 4 * i);
  }
}

void blendRowOverRgb(const std::uint8_t* over, std::uint8_t* under, int count) {
  for (int i = 0; i < count; ++i, over += 4, under += 3) {
    const std::uint32_t left = 255U - over[3];
    if (left == 255) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      under[c] = static_cast<std::uint8_t>(over[2 - c] + scaled<std::uint32_t>(under[c], left));
    }
  }
}

/// Returns the first pixel from `from` on that isn't transparent, testing two at a time, as most
/// are.
int nextCovered(const std::uint8_t* row, int from, int end) {
  constexpr std::uint64_t kAlphas = 0xff000000ff000000;
  for (std::uint64_t two = 0; from + 2 <= end; from += 2) {
    std::memcpy(&two, row + 4 * static_cast<std::ptrdiff_t>(from), sizeof two);
    if ((two & kAlphas) != 0) break;
  }
  while (from < end && row[4 * from + 3] == 0) ++from;
  return from;
}

/// Returns the first pixel from `from` on that is transparent.
int nextClear(const std::uint8_t* row, int from, int end) {
  while (from < end && row[4 * from + 3] > 0) ++from;
  return from;
}

/// Calls `blendRow` for each run of pixels that aren't transparent.
template <typename BlendRow>
void blendRuns(const std::uint8_t* over, std::uint8_t* under, int count, int size,
               const BlendRow& blendRow) {
  for (int first = nextCovered(over, 0, count); first < count;) {
    const int end = nextClear(over, first, count);
    blendRow(over + 4 * static_cast<std::ptrdiff_t>(first),
             under + size * static_cast<std::ptrdiff_t>(first), end - first);
    first = nextCovered(over, end, count);
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

void blend(const LayerView& layer, Image& picture) {
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

}  // namespace rotatebook::image
