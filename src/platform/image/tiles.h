// The tiles of a picture.
#pragma once

#include <algorithm>
#include <cstddef>

#include "image/area.h"

namespace rotatebook::image {

/// Divides a picture into tiles, numbered row by row.
class Tiles {
 public:
  /// The size of a tile; the last ones of a row and a column may be smaller. [pixels]
  static constexpr int kWidth = 64, kHeight = 16;

  /// Takes the picture's size. [pixels]
  Tiles(int width, int height)
      : width_(width), height_(height), columns_((width + kWidth - 1) / kWidth) {}

  int columns() const { return columns_; }
  std::size_t count() const {
    return static_cast<std::size_t>(columns_) *
           static_cast<std::size_t>((height_ + kHeight - 1) / kHeight);
  }

  /// Calls each(number, Area) for each tile that meets `area`, which may be partly outside.
  template <typename Each>
  void forEach(const Area& area, const Each& each) const {
    const Area part = common(area, {0, 0, width_, height_});
    if (part.empty()) return;
    for (int row = part.y / kHeight; row <= (part.bottom() - 1) / kHeight; ++row) {
      for (int column = part.x / kWidth; column <= (part.right() - 1) / kWidth; ++column)
        each(static_cast<std::size_t>(row * columns_ + column), areaOf(row, column));
    }
  }

  /// Calls each(Area) for tiles that meet `area` and of which `has`(number) is true; those beside
  /// each other are one.
  template <typename Has, typename Each>
  void forEachRun(const Area& area, const Has& has, const Each& each) const {
    Area run{};
    forEach(area, [&](std::size_t number, const Area& tile) {
      if (!has(number)) return;
      const bool goesOn = run.y == tile.y && run.right() == tile.x && !run.empty();
      if (!goesOn && !run.empty()) each(run);
      run = goesOn ? Area{run.x, run.y, run.width + tile.width, run.height} : tile;
    });
    if (!run.empty()) each(run);
  }

 private:
  Area areaOf(int row, int column) const {
    const int x = column * kWidth, y = row * kHeight;
    return {x, y, std::min(kWidth, width_ - x), std::min(kHeight, height_ - y)};
  }

  int width_, height_, columns_;
};

}  // namespace rotatebook::image
