#include "picture/map_layout.h"

#include <algorithm>
#include <cmath>

namespace rotatebook::picture {
namespace {

using overlay::Colour;
using overlay::TextStyle;

// Of the plots of all panels together. [pixels]
constexpr int kSmallestPlots = 900, kLargestPlots = 3840;

constexpr Colour kBright{0.97, 0.96, 0.93}, kText{0.86, 0.86, 0.84}, kQuiet{0.66, 0.67, 0.68};

int rounded(double length) {
  return static_cast<int>(std::lround(length));
}

/// Sets how many runs are drawn, and how large.
void scaleRuns(const scene::MapSettings& map, int panels, MapLayout& layout) {
  const int across = map.width * panels;
  layout.scale = std::max(1, (kSmallestPlots + across - 1) / across);
  layout.stride = std::max(1, (across + kLargestPlots - 1) / kLargestPlots);
  const double plots = 1.0 * across * layout.scale / layout.stride;
  layout.letters = std::clamp(6 + 0.0105 * plots, 14.0, 36.0);
}

std::vector<Tick> ticksAlong(const scene::MapAxis& axis, double wanted) {
  const bool isInDegrees =
      axis.kind == scene::AxisKind::SpinLongitude || axis.kind == scene::AxisKind::SpinLatitude;
  return ticksOf(axis.from, axis.to, axis.scale, std::max(2, rounded(wanted)), isInDegrees);
}

int widestTick(const MapLayout& layout, const TextStyle& style, const overlay::Typesetter& type) {
  int widest = 0;
  for (const Tick& tick : layout.yTicks) {
    if (!tick.label.empty()) widest = std::max(widest, type.measure(tick.label, style, 1000).width);
  }
  return widest;
}

}  // namespace

MapStyles::MapStyles(double letters)
    : title{1.7 * letters, true, kBright},
      name{letters, false, kText},
      bold{letters, true, kBright},
      small{0.88 * letters, false, kQuiet},
      caption{1.04 * letters, false, kText} {}

std::string nameOf(const scene::MapAxis& axis) {
  return axis.label.empty() ? axis.key : axis.label;
}

MapLayout layOutMap(const scene::Scene& scene, const overlay::Typesetter& type) {
  const scene::MapSettings& map = *scene.map;
  const int panels = static_cast<int>(motionsOf(scene).size());
  MapLayout layout;
  scaleRuns(map, panels, layout);
  const double em = layout.letters;
  const MapStyles styles(em);
  const int plotWidth = (map.width + layout.stride - 1) / layout.stride * layout.scale;
  const int plotHeight = (map.height + layout.stride - 1) / layout.stride * layout.scale;
  layout.xTicks = ticksAlong(map.x, plotWidth / (7 * em));
  layout.yTicks = ticksAlong(map.y, plotHeight / (4.5 * em));

  // Across
  const int margin = rounded(2.4 * em), gap = rounded(3.2 * em);
  const int left = margin + widestTick(layout, styles.small, type) + rounded(1.0 * em);
  layout.textWidth = panels * plotWidth + (panels - 1) * gap;
  layout.width = left + layout.textWidth + margin;

  // From the top to the bottom
  const auto below = [&](const std::string& text, const TextStyle& style) {
    return text.empty() ? 0 : type.measure(text, style, layout.textWidth).height;
  };
  layout.titleTop = margin;
  layout.legendTop = layout.titleTop + below(scene.title, styles.title) + rounded(1.1 * em);
  layout.axisNameTop = layout.legendTop + rounded(3.3 * em);
  layout.panelNameTop = layout.axisNameTop + rounded(1.9 * em);
  const int plotTop = panels > 1 ? layout.panelNameTop + rounded(1.8 * em) : layout.panelNameTop;
  for (int panel = 0; panel < panels; ++panel) {
    layout.plots.push_back({1.0 * (left + panel * (plotWidth + gap)), 1.0 * plotTop,
                            1.0 * plotWidth, 1.0 * plotHeight});
  }
  layout.xNameTop = plotTop + plotHeight + rounded(2.1 * em);
  layout.captionTop = layout.xNameTop + rounded(2.5 * em);
  const int caption = below(scene.caption, styles.caption);
  layout.height = layout.captionTop + caption + (caption > 0 ? margin : 0);
  return layout;
}

}  // namespace rotatebook::picture
