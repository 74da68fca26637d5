#include "video/opaque_converter.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "image/tiles.h"

namespace rotatebook::video {
namespace {

// Samples of a vector, and those that are written past the end of a row at most.
constexpr int kAtOnce = 16, kOverrun = 2 * kAtOnce;

#ifdef __x86_64__

#define ROTATEBOOK_INLINE [[gnu::target("avx2"), gnu::always_inline]] inline

using Ints [[gnu::vector_size(32)]] = std::int32_t;
using Shorts [[gnu::vector_size(32)]] = std::int16_t;
using FullBytes [[gnu::vector_size(32)]] = char;
using HalfBytes [[gnu::vector_size(16)]] = char;

template <typename Vector, typename Number>
ROTATEBOOK_INLINE void take(const Number* from, Vector& vector) {
  std::memcpy(&vector, from, sizeof vector);
}

/// Weights of red, green and blue in one of Y, U and V. [1/32768]
struct Weights {
  std::int16_t red, green, blue;
};

// BT.709's, limited range, as swscale rounds them.
constexpr Weights kY{5983, 20127, 2032}, kU{-3298, -11094, 14392}, kV{14392, -13073, -1320};

/// Repeats two words throughout a vector.
ROTATEBOOK_INLINE Shorts pairs(std::int16_t even, std::int16_t odd) {
  return Shorts{even, odd, even, odd, even, odd, even, odd,
                even, odd, even, odd, even, odd, even, odd};
}

/// Returns for each pair of words the sum of its products with `weights`.
ROTATEBOOK_INLINE Ints sums(const Shorts& words, const Shorts& weights) {
  return (Ints)__builtin_ia32_pmaddwd256(words, weights);
}

/// Joins two vectors of numbers that words can hold.
ROTATEBOOK_INLINE Shorts packed(const Ints& first, const Ints& second) {
  const auto both = (Ints)__builtin_ia32_packssdw256(first, second);
  return (Shorts)__builtin_shufflevector(both, both, 0, 1, 4, 5, 2, 3, 6, 7);
}

/// Alternates the lower four, or the higher four, of each eight words of both.
ROTATEBOOK_INLINE Shorts lows(const Shorts& one, const Shorts& other) {
  return __builtin_shufflevector(one, other, 0, 16, 1, 17, 2, 18, 3, 19, 8, 24, 9, 25, 10, 26, 11,
                                 27);
}
ROTATEBOOK_INLINE Shorts highs(const Shorts& one, const Shorts& other) {
  return __builtin_shufflevector(one, other, 4, 20, 5, 21, 6, 22, 7, 23, 12, 28, 13, 29, 14, 30, 15,
                                 31);
}

/// Writes the first `count` of 16 numbers from 0 to 255, at most all.
ROTATEBOOK_INLINE void store(const Shorts& words, std::uint8_t* to, int count) {
  const auto both = (Ints)__builtin_ia32_packuswb256(words, words);
  const auto ordered = (FullBytes)__builtin_shufflevector(both, both, 0, 1, 4, 5, 2, 3, 6, 7);
  const HalfBytes bytes = __builtin_shufflevector(ordered, ordered, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9,
                                                  10, 11, 12, 13, 14, 15);
  if (count >= kAtOnce) {
    std::memcpy(to, &bytes, sizeof bytes);
  } else {
    std::memcpy(to, &bytes, static_cast<std::size_t>(count));
  }
}

/// 16 pixels, red and blue apart from green.
struct Pixels {
  std::array<Shorts, 2> redBlue, green;
};

ROTATEBOOK_INLINE Pixels pixelsAt(const std::uint8_t* rgba) {
  constexpr std::int32_t kEvenBytes = 0x00ff00ff;
  Pixels pixels;
  for (std::size_t i = 0; i < 2; ++i) {
    Ints eight;
    take(rgba + sizeof(Ints) * i, eight);
    pixels.redBlue[i] = (Shorts)(eight & kEvenBytes);
    pixels.green[i] = (Shorts)(eight >> 8 & kEvenBytes);
  }
  return pixels;
}

/// Returns the weighted sums, plus `added`, shifted by kShift bits.
template <int kShift>
ROTATEBOOK_INLINE Shorts weighted(const Pixels& pixels, const Weights& weights,
                                  std::int32_t added) {
  const Shorts redBlue = pairs(weights.red, weights.blue), green = pairs(weights.green, 0);
  std::array<Ints, 2> all;
  for (std::size_t i = 0; i < 2; ++i) {
    all[i] = (sums(pixels.redBlue[i], redBlue) + sums(pixels.green[i], green) + added) >> kShift;
  }
  return packed(all[0], all[1]);
}

/// Converts pixels of a row from `left` on, at least kAtOnce, to luma, and to colours with 6 more
/// bits.
[[gnu::target("avx2")]] void weigh(const std::uint8_t* rgba, int left, int right,
                                   std::uint8_t* luma, std::int16_t* u, std::int16_t* v) {
  // swscale rounds down to 6 more bits, whose half it has added, then to the nearest
  constexpr std::int32_t kHalf = 1 << 8, kNearest = 1 << 14, kOne = 1 << 15;
  for (int next = left; next < right; next += kAtOnce) {
    const int x = std::min(next, right - kAtOnce);  // The last ones may be converted twice.
    const Pixels pixels = pixelsAt(rgba + 4 * static_cast<std::ptrdiff_t>(x));
    store(weighted<15>(pixels, kY, 16 * kOne + kHalf + kNearest), luma + x, kAtOnce);
    const Shorts blue = weighted<9>(pixels, kU, 128 * kOne + kHalf);
    const Shorts red = weighted<9>(pixels, kV, 128 * kOne + kHalf);
    std::memcpy(u + x, &blue, sizeof blue);
    std::memcpy(v + x, &red, sizeof red);
  }
}

/// Mixes `count` colours, of 7 more bits, each of its pixel and half of both beside it.
[[gnu::target("avx2")]] void halve(const std::int16_t* colours, int count, std::int16_t* halved) {
  const Shorts ones = pairs(1, 1);
  for (int x = 0; x < count; x += kAtOnce) {
    std::array<Ints, 2> mixed;
    for (int i = 0; i < 2; ++i) {
      Shorts right, left;
      take(colours + 2 * x + kAtOnce * i, right);
      take(colours + 2 * x + kAtOnce * i - 1, left);
      mixed[static_cast<std::size_t>(i)] = (sums(right, ones) + sums(left, ones)) >> 1;
    }
    const Shorts both = packed(mixed[0], mixed[1]);
    std::memcpy(halved + x, &both, sizeof both);
  }
}

/// Mixes `count` colours of four rows.
[[gnu::target("avx2")]] void mix(const std::array<const std::int16_t*, 4>& rows, int count,
                                 std::uint8_t* colours) {
  constexpr std::int32_t kNearest = 1 << 9;
  const Shorts outer = pairs(1, 3), inner = pairs(3, 1);
  for (int x = 0; x < count; x += kAtOnce) {
    Shorts a, b, c, d;
    take(rows[0] + x, a);
    take(rows[1] + x, b);
    take(rows[2] + x, c);
    take(rows[3] + x, d);
    const Ints lower = sums(lows(a, b), outer) + sums(lows(c, d), inner) + kNearest;
    const Ints higher = sums(highs(a, b), outer) + sums(highs(c, d), inner) + kNearest;
    const auto mixed = (Shorts)__builtin_ia32_packssdw256(lower >> 10, higher >> 10);
    store(mixed, colours + x, count - x);
  }
}

#undef ROTATEBOOK_INLINE

#else

void weigh(const std::uint8_t*, int, int, std::uint8_t*, std::int16_t*, std::int16_t*) {}
void halve(const std::int16_t*, int, std::int16_t*) {}
void mix(const std::array<const std::int16_t*, 4>&, int, std::uint8_t*) {}

#endif

}  // namespace

OpaqueConverter::OpaqueConverter(int width)
    : size_(static_cast<std::size_t>(width) + kOverrun),
      colours_(2 * size_),
      halved_(kRows * size_) {}

void OpaqueConverter::convert(const image::ImageView& picture, AVFrame& frame) {
  const image::Tiles tiles(picture.width, picture.height);
  const image::Area all{0, 0, picture.width, picture.height};
  const bool isKnown = picture.marks != nullptr && marks_.size() == tiles.count();
  const auto differs = [&](std::size_t tile) {
    return marks_[tile] == 0 || marks_[tile] != picture.marks[tile];
  };
  // Colours are mixed from rows above and below
  const auto columns = static_cast<std::size_t>(tiles.columns());
  const auto isStale = [&](std::size_t tile) {
    return differs(tile) || (tile >= columns && differs(tile - columns)) ||
           (tile + columns < tiles.count() && differs(tile + columns));
  };
  if (isKnown) {
    tiles.forEachRun(all, isStale,
                     [&](const image::Area& run) { convertArea(picture, run, frame); });
  } else {
    convertArea(picture, all, frame);
  }
  marks_.clear();
  if (picture.marks != nullptr) marks_.assign(picture.marks, picture.marks + tiles.count());
}

void OpaqueConverter::convertArea(const image::ImageView& picture, image::Area area,
                                  AVFrame& frame) {
  // The colour beside it is mixed from its last pixels, too
  area.width = std::min(area.width + 2, picture.width - area.x);
  int next = std::max(area.y - 1, 0);
  for (int row = area.y / 2; row < area.bottom() / 2; ++row) {
    for (; next < std::min(2 * row + 3, picture.height); ++next)
      convertRow(picture, next, area, frame);
    mixRows(row, picture.height, area, frame);
  }
}

/// Returns one colour of a row of pixels, at half of its width.
std::int16_t* OpaqueConverter::halved(int row, std::size_t colour) {
  return &halved_[static_cast<std::size_t>(row) % kRows * size_ + colour * size_ / 2];
}

void OpaqueConverter::convertRow(const image::ImageView& picture, int row, const image::Area& area,
                                 AVFrame& frame) {
  std::int16_t *u = &colours_[1], *v = &colours_[1 + size_];
  weigh(picture.row(row), std::max(area.x - kAtOnce, 0), area.right(),
        frame.data[0] + std::ptrdiff_t{row} * frame.linesize[0], u, v);
  u[-1] = u[0];
  v[-1] = v[0];
  halve(u + area.x, area.width / 2, halved(row, 0) + area.x / 2);
  halve(v + area.x, area.width / 2, halved(row, 1) + area.x / 2);
}

void OpaqueConverter::mixRows(int row, int height, const image::Area& area, AVFrame& frame) {
  for (std::size_t colour = 0; colour < 2; ++colour) {
    const auto at = [&](int y) {
      return halved(std::clamp(y, 0, height - 1), colour) + area.x / 2;
    };
    const std::array<const std::int16_t*, kRows> rows{at(2 * row - 1), at(2 * row), at(2 * row + 1),
                                                      at(2 * row + 2)};
    std::uint8_t* out = frame.data[colour + 1] + std::ptrdiff_t{row} * frame.linesize[colour + 1];
    mix(rows, area.width / 2, out + area.x / 2);
  }
}

}  // namespace rotatebook::video
