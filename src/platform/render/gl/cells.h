// Frame buffers for several bodies at once. Inside the room only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geometry/hull_bands.h"
#include "render/antialias/strips.h"
#include "render/gl/frame_target.h"

namespace rotatebook::render {

/// Frame buffers in which several bodies have room side by side.
struct Cells {
  /// Takes the size of a body's picture [pixels] and the number of its strips.
  Cells(std::size_t count, int width, int height, int stripCount)
      : pixelCells(cellsOf(count, width, height)),
        stripCells(cellsOf(count, DrawnStrips::kColumns, stripCount)),
        pixels(all(pixelCells).width, all(pixelCells).height),
        strips(all(stripCells).width, all(stripCells).height) {}

  std::size_t count() const { return pixelCells.size(); }

  static std::vector<geometry::PixelRect> cellsOf(std::size_t count, int width, int height) {
    constexpr int kWidest = 4096;  // [pixels]
    const int columns = std::clamp(kWidest / width, 1, static_cast<int>(count));
    std::vector<geometry::PixelRect> cells;
    for (int i = 0; i < static_cast<int>(count); ++i) {
      cells.push_back({i % columns * width, i / columns * height, width, height});
    }
    return cells;
  }

  /// Returns the area of all cells together.
  static geometry::PixelRect all(const std::vector<geometry::PixelRect>& cells) {
    geometry::PixelRect area{};
    for (const geometry::PixelRect& cell : cells) {
      area.width = std::max(area.width, cell.x + cell.width);
      area.height = std::max(area.height, cell.y + cell.height);
    }
    return area;
  }

  std::vector<geometry::PixelRect> pixelCells, stripCells;
  FrameTarget pixels, strips;
};

}  // namespace rotatebook::render
