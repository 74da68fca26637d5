#include "overlay/layout.h"

#include <algorithm>
#include <cmath>

namespace rotatebook::overlay {
namespace {

// In any attitude the book stays within a circle about as wide as the camera's picture is high. A
// column of insets needs at least this share of the width beside it.
constexpr double kMinSide = 0.17;
constexpr double kWidestColumn = 0.25;  // share of the width
// Share of the column's height, with charts and alone.
constexpr double kSquareShare = 0.42, kLoneSquare = 0.55;
constexpr double kChartAspect = 0.52;  // largest height of a chart in a column, per its width
constexpr double kLowestChart = 6.5;   // at the bottom [letter heights]
constexpr double kLowestInColumn = 5;  // [letter heights]
constexpr double kBottomChart = 0.15;  // share of the height
constexpr double kMaxCharts = 0.4;     // share of the height that all charts at the bottom take
constexpr double kAboveCharts = 0.2;   // share of the height above them, which other text needs,
constexpr double kLinesAbove = 4;      // and as many letter heights at least
constexpr double kCornerSquare = 0.3;  // share of the shorter side
constexpr double kWidestSquare = 0.5;  // likewise, however large the overlays are
constexpr double kLegendWidth = 9.5;   // [letter heights]
// A legend that takes more of the width and of the height is in the body's way.
constexpr double kWidestLegend = 0.5, kHighestLegend = 0.3;
constexpr double kNarrowestLegend = 8;  // [small letters]

double gapOf(const Scale& scale) {
  return 0.4 * scale.margin;
}

void placeColumn(const Scale& scale, const Wanted& wanted, double side, Layout& layout) {
  const double width = std::min(scale.factor * kWidestColumn * scale.width, side - scale.margin);
  const double left = scale.width - scale.margin - width, gap = gapOf(scale);
  const double height = scale.height - wanted.bottomRows - 2 * scale.margin;
  double top = scale.margin;
  if (wanted.square) {
    const double share = wanted.charts > 0 ? kSquareShare : kLoneSquare;
    const double size = std::min(width, share * height);
    // As wide as the charts below it.
    const double across = wanted.charts > 0 ? width : size;
    layout.square = {left + width - across, top, across, size};
    top += size + gap;
  }
  const double rest = scale.margin + height - top + gap;
  const double each = wanted.charts > 0 ? rest / wanted.charts - gap : 0;
  const double chart = std::min(kChartAspect * width, each);
  for (int i = 0; i < wanted.charts; ++i, top += chart + gap) {
    layout.charts.push_back({left, top, width, chart});
  }
}

/// Places the charts at the bottom, side by side or one above the other; those for which there is
/// no room are left empty.
void placeCharts(const Scale& scale, const Wanted& wanted, Layout& layout) {
  const double room = scale.width - 2 * scale.margin, gap = gapOf(scale);
  const double height =
      std::max(scale.factor * kBottomChart * scale.height, kLowestChart * scale.smallLetters);
  const int abreast = room > 40 * scale.smallLetters ? wanted.charts : 1;
  const double width = (room + gap) / abreast - gap;
  const double lowest =
      scale.height - (wanted.bottomRows > 0 ? wanted.bottomRows : scale.margin) - gap;
  const double above =
      std::max(kAboveCharts * scale.height, scale.margin + kLinesAbove * scale.letters);
  const double most = std::min(kMaxCharts * scale.height, lowest - above);
  const int max = std::max(0, static_cast<int>(most / (height + gap)));
  const int lines = std::min(wanted.charts / abreast, max);
  layout.charts.resize(static_cast<std::size_t>(wanted.charts));
  if (lines == 0) return;
  const double top = lowest - lines * (height + gap) + gap;
  for (int i = 0; i < lines * abreast; ++i) {
    layout.charts[static_cast<std::size_t>(i)] = {scale.margin + (i % abreast) * (width + gap),
                                                  top + (i / abreast) * (height + gap), width,
                                                  height};
  }
  const int rows = static_cast<int>(std::ceil(scale.height - top + gap));
  layout.bottomRows = std::min(rows, std::max(wanted.bottomRows, 2 * scale.height / 3));
}

void placeAround(const Scale& scale, const Wanted& wanted, Layout& layout) {
  if (wanted.charts > 0) placeCharts(scale, wanted, layout);
  if (wanted.square) {
    const double side = std::min<double>(scale.width, scale.height - layout.bottomRows);
    const double size = std::min(scale.factor * kCornerSquare, kWidestSquare) * side;
    layout.square = {scale.width - scale.margin - size, scale.margin, size, size};
  }
}

/// Places the legend at the lower left, above text and charts; nothing in a very narrow picture.
void placeLegend(const Scale& scale, const Wanted& wanted, Layout& layout) {
  const double width = std::min(kLegendWidth * scale.letters, scale.width - 2 * scale.margin);
  if (width < kNarrowestLegend * scale.smallLetters) return;
  double height = wanted.legend * scale.smallLetters;
  if (width > kWidestLegend * scale.width ||
      height > kHighestLegend * (scale.height - layout.bottomRows))
    height = wanted.leastLegend * scale.smallLetters;
  double below = scale.height - scale.margin;
  if (layout.bottomRows > 0) below = scale.height - layout.bottomRows - gapOf(scale);
  for (const Box& chart : layout.charts) {
    if (!chart.empty() && chart.x < scale.width / 2.0)
      below = std::min(below, chart.y - gapOf(scale));
  }
  layout.legend = {scale.margin, below - height, width, height};
}

}  // namespace

Layout layOut(const Scale& scale, const Wanted& wanted) {
  Layout layout;
  layout.bottomRows = wanted.bottomRows;
  const double side = (scale.width - (scale.height - wanted.bottomRows)) / 2.0;
  if (side >= kMinSide * scale.width) placeColumn(scale, wanted, side, layout);
  const auto legible = [&](const Box& chart) {
    return chart.height >= kLowestInColumn * scale.smallLetters;
  };
  if (side < kMinSide * scale.width || !std::ranges::all_of(layout.charts, legible)) {
    layout = {.bottomRows = wanted.bottomRows};
    placeAround(scale, wanted, layout);
  }
  if (wanted.legend > 0) placeLegend(scale, wanted, layout);
  return layout;
}

}  // namespace rotatebook::overlay
