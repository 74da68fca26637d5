#include "image/image.h"

#include <algorithm>
#include <atomic>
#include <cassert>

namespace rotatebook::image {
namespace {

/// Returns a mark that nothing has yet.
std::uint64_t newMark() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

Image::Image(int width, int height, PixelFormat format)
    : width_(width), height_(height), format_(format) {
  assert(width > 0 && height > 0);
  bytes_.resize(static_cast<std::size_t>(stride()) * static_cast<std::size_t>(height));
}

void Image::beginOn(const Image& ground) {
  if (width_ != ground.width_ || height_ != ground.height_ || format_ != ground.format_)
    *this = Image(ground.width_, ground.height_, ground.format_);
  marks_.resize(Tiles(width_, height_).count());
  own_ = newMark();
  ground_ = &ground;
}

void Image::touch(const Area& area) {
  if (marks_.empty()) return;
  const std::uint64_t mark = ground_ != nullptr ? own_ : newMark();
  Tiles(width_, height_).forEach(area, [&](std::size_t number, const Area& tile) {
    if (marks_[number] == mark) return;
    if (ground_ != nullptr) copyTile(*ground_, tile);
    marks_[number] = mark;
  });
}

void Image::settle(const Image& rest) {
  Tiles(width_, height_).forEach(area(), [&](std::size_t number, const Area& tile) {
    if (marks_[number] == own_ || marks_[number] == rest.marks_[number]) return;
    copyTile(rest, tile);
    marks_[number] = rest.marks_[number];
  });
  ground_ = nullptr;
}

void Image::mark() {
  marks_.resize(Tiles(width_, height_).count());
  std::ranges::generate(marks_, newMark);
}

void Image::copyTile(const Image& from, const Area& tile) {
  const std::ptrdiff_t size = bytesPerPixel(format_);
  for (int y = tile.y; y < tile.bottom(); ++y)
    std::copy_n(from.row(y) + tile.x * size, tile.width * size, row(y) + tile.x * size);
}

void paste(const ImageView& piece, int x, int y, Image& picture) {
  assert(piece.format == picture.format() && x >= 0 && y >= 0);
  assert(x + piece.width <= picture.width() && y + piece.height <= picture.height());
  picture.touch({x, y, piece.width, piece.height});
  const std::ptrdiff_t size = bytesPerPixel(piece.format);
  const Pixels pixels = picture.from(x, y);
  for (int row = 0; row < piece.height; ++row)
    std::copy_n(piece.row(row), piece.width * size, pixels.row(row));
}

}  // namespace rotatebook::image
