#include "render/blank_area.h"

#include <cstddef>
#include <cstring>

namespace rotatebook::render {
namespace {

constexpr int kSmallestSide = 64;  // [pixels] The background alone changes its shade within this.
constexpr std::ptrdiff_t kPixelBytes = 4;

}  // namespace

bool isBlank(const image::Image& picture, const PixelRect& area) {
  if (area.width < kSmallestSide || area.height < kSmallestSide) return false;
  const std::uint8_t* first = picture.row(area.y) + kPixelBytes * area.x;
  const auto rowBytes = static_cast<std::size_t>(kPixelBytes * area.width);
  for (int y = 0; y < area.height; ++y) {
    const std::uint8_t* row = first + y * picture.stride();
    if (std::memcmp(row, first, static_cast<std::size_t>(kPixelBytes)) != 0) return false;
    if (std::memcmp(row, row + kPixelBytes, rowBytes - kPixelBytes) != 0) return false;
  }
  return true;
}

}  // namespace rotatebook::render
