#include "plot/panel_grid.h"

#include <algorithm>
#include <cmath>

namespace rotatebook::plot {
namespace {

constexpr double kPanelGap = 0.004;  // share of the shorter side
constexpr int kSmallestGap = 2;      // [pixels]

/// Returns the side of each of `panels` that share `room`. [pixels]
int shareOf(int room, int panels, int gap) {
  return std::max(1, (room - (panels - 1) * gap) / panels);
}

int rowsFor(int count, int columns) {
  return (count + columns - 1) / columns;
}

}  // namespace

PanelGrid panelGrid(int count, int width, int height) {
  const int gap =
      std::max(kSmallestGap, static_cast<int>(std::lround(kPanelGap * std::min(width, height))));
  const auto shorterSide = [&](int columns) {
    return std::min(shareOf(width, columns, gap), shareOf(height, rowsFor(count, columns), gap));
  };
  const auto unused = [&](int columns) { return columns * rowsFor(count, columns) - count; };
  int columns = count;
  for (int fewer = count - 1; fewer >= 1; --fewer) {
    const int gain = shorterSide(fewer) - shorterSide(columns);
    if (gain > 0 || (gain == 0 && unused(fewer) < unused(columns))) columns = fewer;
  }
  const int rows = rowsFor(count, columns);
  PanelGrid grid{shareOf(width, columns, gap), shareOf(height, rows, gap), {}};
  for (int panel = 0; panel < count; ++panel) {
    const int row = panel / columns;
    const int inRow = std::min(columns, count - row * columns);
    const int rowWidth = inRow * grid.width + (inRow - 1) * gap;
    grid.positions.push_back(
        {(width - rowWidth) / 2 + panel % columns * (grid.width + gap), row * (grid.height + gap)});
  }
  return grid;
}

}  // namespace rotatebook::plot
