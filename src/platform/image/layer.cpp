#include "image/layer.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "image/alpha_mask.h"
#include "image/wide_vectors.h"

namespace rotatebook::image {
namespace {

// Four pixels as bytes, and as wider numbers: few instructions compute with all their channels.
constexpr int kAtOnce = 4;
using Bytes [[gnu::vector_size(4 * kAtOnce)]] = std::uint8_t;
using Numbers [[gnu::vector_size(8 * kAtOnce)]] = std::uint16_t;

/// Multiplies by factor / 255, rounded. By reference: how wide vectors are passed differs from
/// compiler to compiler.
template <typename Number>
[[gnu::always_inline]] inline void scale(Number& value, const Number& factor) {
  value = value * factor + 128;
  value = (value + (value >> 8)) >> 8;
}

/// Blends four pixels over opaque ones.
[[gnu::always_inline]] inline void blendFourOverOpaque(const std::uint8_t* over,
                                                       std::uint8_t* under) {
  Bytes top, bottom;
  std::memcpy(&top, over, sizeof top);
  std::memcpy(&bottom, under, sizeof bottom);
  const Bytes alphas =
      __builtin_shufflevector(top, top, 3, 3, 3, 3, 7, 7, 7, 7, 11, 11, 11, 11, 15, 15, 15, 15);
  const Bytes redFirst =
      __builtin_shufflevector(top, top, 2, 1, 0, 3, 6, 5, 4, 7, 10, 9, 8, 11, 14, 13, 12, 15);
  auto shown = __builtin_convertvector(bottom, Numbers);
  scale(shown, __builtin_convertvector(255 - alphas, Numbers));
  const Bytes sum = redFirst + __builtin_convertvector(shown, Bytes);
  std::memcpy(under, &sum, sizeof sum);
}

[[gnu::always_inline]] inline void blendOpaqueRow(const std::uint8_t* over, std::uint8_t* under,
                                                  int count) {
  for (; count >= kAtOnce; count -= kAtOnce, over += sizeof(Bytes), under += sizeof(Bytes))
    blendFourOverOpaque(over, under);
  if (count == 0) return;
  const std::size_t rest = 4 * static_cast<std::size_t>(count);
  std::array<std::uint8_t, sizeof(Bytes)> top{}, bottom{};
  std::memcpy(top.data(), over, rest);
  std::memcpy(bottom.data(), under, rest);
  blendFourOverOpaque(top.data(), bottom.data());
  std::memcpy(under, bottom.data(), rest);
}

void blendByBase(const std::uint8_t* over, std::uint8_t* under, int count) {
  blendOpaqueRow(over, under, count);
}

ROTATEBOOK_AVX2 void blendByAvx2(const std::uint8_t* over, std::uint8_t* under, int count) {
  blendOpaqueRow(over, under, count);
}

const auto blendRowOverOpaque = usesAvx2() ? &blendByAvx2 : &blendByBase;

/// Blends a pixel over one with straight alpha: both colours are weighted by their share of the
/// sum.
void blendOverClear(const std::uint8_t* over, std::uint8_t* under) {
  std::uint32_t share = under[3];
  scale(share, 255U - over[3]);
  const std::uint32_t alpha = over[3] + share;
  if (alpha == 0) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t sum = 255U * over[2 - i] + share * under[i];
    under[i] = static_cast<std::uint8_t>(std::min(255U, (sum + alpha / 2) / alpha));
  }
  under[3] = static_cast<std::uint8_t>(alpha);
}

/// Returns whether all alphas of a row are 255. Pixels as integers: the compiler vectorises the
/// loop.
bool isOpaque(const std::uint8_t* row, int count) {
  std::uint32_t common = kAlphaMask;
  for (int i = 0; i < count; ++i, row += 4) {
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, row, 4);
    common &= pixel;
  }
  return common == kAlphaMask;
}

void blendRowOverRgba(const std::uint8_t* over, std::uint8_t* under, int count) {
  if (isOpaque(under, count)) return blendRowOverOpaque(over, under, count);
  for (int i = 0; i < count; ++i) {
    if (over[4 * i + 3] > 0) blendOverClear(over + 4 * i, under + 4 * i);
  }
}

void blendRowOverRgb(const std::uint8_t* over, std::uint8_t* under, int count) {
  for (int i = 0; i < count; ++i, over += 4, under += 3) {
    const std::uint32_t left = 255U - over[3];
    if (left == 255) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t shown = under[c];
      scale(shown, left);
      under[c] = static_cast<std::uint8_t>(over[2 - c] + shown);
    }
  }
}

/// Returns the first pixel from `from` on that isn't transparent, testing two at a time, as most
/// are.
int nextCovered(const std::uint8_t* row, int from, int end) {
  constexpr std::uint64_t kAlphas = std::uint64_t{kAlphaMask} << 32 | kAlphaMask;
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

/// Blends what of `layer` is within `part`, an area of both.
void blendPart(const Area& part, const LayerView& layer, Image& picture) {
  const int size = bytesPerPixel(picture.format());
  const auto blendRow = size == 4 ? &blendRowOverRgba : &blendRowOverRgb;
  const std::ptrdiff_t left = part.x - layer.x;
  const Pixels under = picture.from(part.x, part.y);
  for (int y = 0; y < part.height; ++y) {
    blendRuns(layer.pixels + (part.y + y - layer.y) * layer.stride + left * 4, under.row(y),
              part.width, size, blendRow);
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
  blendWithin(picture.area(), layer, picture);
}

void blendWithin(const Area& area, const LayerView& layer, Image& picture) {
  const Area part =
      common({layer.x, layer.y, layer.width, layer.height}, common(area, picture.area()));
  if (part.empty()) return;
  picture.touch(part);
  blendPart(part, layer, picture);
}

void blendOverTouched(const Area& area, const LayerView& layer, Image& picture) {
  const Area whole = common({layer.x, layer.y, layer.width, layer.height}, area);
  picture.forEachTouched(
      whole, [&](const Area& tiles) { blendPart(common(whole, tiles), layer, picture); });
}

}  // namespace rotatebook::image
