#include "image/exif.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace rotatebook::image {
namespace {

constexpr std::array<std::uint8_t, 6> kExifHead = {'E', 'x', 'i', 'f', 0, 0};
constexpr std::size_t kTiffMark = 42, kOrientationTag = 0x0112, kShort = 3, kEntrySize = 12;

/// A TIFF of which anything may be false. Numbers beyond its end are 0.
struct Tiff {
  std::span<const std::uint8_t> bytes;

  std::size_t number(std::size_t at, std::size_t size) const {
    if (at > bytes.size() || size > bytes.size() - at) return 0;
    const bool bigEndian = bytes[0] == 'M';
    std::size_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value = value << 8 | bytes[at + (bigEndian ? i : size - 1 - i)];
    }
    return value;
  }
};

}  // namespace

int orientationOf(std::span<const std::uint8_t> exif) {
  const bool hasHead =
      exif.size() > kExifHead.size() && std::ranges::equal(exif.first(kExifHead.size()), kExifHead);
  const Tiff tiff{hasHead ? exif.subspan(kExifHead.size()) : exif};
  if (tiff.number(2, 2) != kTiffMark) return 1;
  const std::size_t directory = tiff.number(4, 4), count = tiff.number(directory, 2);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t entry = directory + 2 + i * kEntrySize;
    if (tiff.number(entry, 2) != kOrientationTag || tiff.number(entry + 2, 2) != kShort) continue;
    const std::size_t orientation = tiff.number(entry + 8, 2);
    return orientation >= 1 && orientation <= 8 ? static_cast<int>(orientation) : 1;
  }
  return 1;
}

Image upright(Image stored, int orientation) {
  assert(orientation >= 1 && orientation <= 8);
  if (orientation == 1) return stored;
  const int o = orientation, width = stored.width(), height = stored.height();
  const bool swapped = o >= 5;
  const bool flippedX = o == 2 || o == 3 || o == 7 || o == 8;
  const bool flippedY = o == 3 || o == 4 || o == 6 || o == 7;
  Image turned(swapped ? height : width, swapped ? width : height, stored.format());
  const std::ptrdiff_t size = bytesPerPixel(stored.format());
  for (int y = 0; y < turned.height(); ++y) {
    for (int x = 0; x < turned.width(); ++x) {
      const int a = swapped ? y : x, b = swapped ? x : y;
      const std::uint8_t* row = stored.row(flippedY ? height - 1 - b : b);
      std::copy_n(row + size * (flippedX ? width - 1 - a : a), size, turned.row(y) + size * x);
    }
  }
  return turned;
}

}  // namespace rotatebook::image
