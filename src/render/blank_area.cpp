#include "render/blank_area.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace rotatebook::render {
namespace {

constexpr int kSmallestSide = 64;  // [pixels]
constexpr std::ptrdiff_t kPixelBytes = 4;

}  // namespace

bool isBlank(const image::Image& picture, const std::vector<PixelRect>& bands) {
  int width = 0, height = 0;
  for (const PixelRect& band : bands) {
    width = std::max(width, band.width);
    height += band.height;
  }
  if (width < kSmallestSide || height < kSmallestSide) return false;
  const std::uint8_t* first = picture.row(bands[0].y) + kPixelBytes * bands[0].x;
  for (const PixelRect& band : bands) {
    for (int y = band.y; y < band.y + band.height; ++y) {
      const std::uint8_t* row = picture.row(y) + kPixelBytes * band.x;
      const auto rest = static_cast<std::size_t>(kPixelBytes * (band.width - 1));
      if (std::memcmp(row, first, kPixelBytes) != 0) return false;
      if (std::memcmp(row, row + kPixelBytes, rest) != 0) return false;
    }
  }
  return true;
}

}  // namespace rotatebook::render
