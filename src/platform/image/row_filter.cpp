#include "image/row_filter.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "image/wide_vectors.h"

namespace rotatebook::image {
namespace {

/// Returns the eight bytes at `from`, the first one lowest.
std::uint64_t loadWord(const std::uint8_t* from) {
  std::uint64_t word = 0;
  std::memcpy(&word, from, sizeof word);
  return std::endian::native == std::endian::little ? word : __builtin_bswap64(word);
}

void storeWord(std::uint8_t* to, std::uint64_t word) {
  if (std::endian::native != std::endian::little) word = __builtin_bswap64(word);
  std::memcpy(to, &word, sizeof word);
}

/// Subtracts the bytes of `left` from those of `row`, all eight at once.
std::uint64_t differences(std::uint64_t row, std::uint64_t left) {
  constexpr std::uint64_t kHighest = 0x8080808080808080;
  return ((row | kHighest) - (left & ~kHighest)) ^ ((row ^ ~left) & kHighest);
}

/// Subtracts colours of RGBA from those to their right. Two pixels a step in one register.
void subtractColoursByBase(const std::uint8_t* row, int pixels, std::uint8_t* out) {
  constexpr std::uint64_t kFirst = 0xffffff;
  int x = 0;
  for (; x + 2 <= pixels; x += 2, row += 8, out += 6) {
    const std::uint64_t both = differences(loadWord(row), loadWord(row - 4));
    storeWord(out, (both & kFirst) | ((both >> 8) & (kFirst << 24)));
  }
  for (; x < pixels; ++x, row += 4) {
    for (int c = 0; c < 3; ++c) *out++ = static_cast<std::uint8_t>(row[c] - row[c - 4]);
  }
}

using FourPixels [[gnu::vector_size(16)]] = std::uint8_t;

ROTATEBOOK_AVX2 void subtractColoursByAvx2(const std::uint8_t* row, int pixels, std::uint8_t* out) {
  int x = 0;
  for (; x + 4 <= pixels; x += 4, row += 16, out += 12) {
    FourPixels four, left;
    std::memcpy(&four, row, sizeof four);
    std::memcpy(&left, row - 4, sizeof left);
    four -= left;
    four =
        __builtin_shufflevector(four, four, 0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15);
    std::memcpy(out, &four, sizeof four);
  }
  subtractColoursByBase(row, pixels - x, out);
}

const auto subtractColours = usesAvx2() ? &subtractColoursByAvx2 : &subtractColoursByBase;

void subtract(const std::uint8_t* row, std::size_t bytes, std::size_t pixel, std::uint8_t* out) {
  for (std::size_t i = 0; i < bytes; ++i)
    out[i] = static_cast<std::uint8_t>(row[i] - (row - pixel)[i]);
}

}  // namespace

void filterPixels(const ImageView& view, int y, int left, int count, bool alpha,
                  std::uint8_t* out) {
  const int pixel = bytesPerPixel(view.format), kept = alpha ? 4 : 3;
  const std::uint8_t* row = view.row(y) + static_cast<std::ptrdiff_t>(left) * pixel;
  if (left == 0) {
    out = std::copy_n(row, kept, out);
    row += pixel;
    --count;
  }
  if (pixel == kept) {
    subtract(row, static_cast<std::size_t>(count * pixel), static_cast<std::size_t>(pixel), out);
  } else {
    subtractColours(row, count, out);
  }
}

}  // namespace rotatebook::image
