#include "plot/map_layout.h"

#include <algorithm>
#include <cmath>

namespace rotatebook::plot {
namespace {

// Of the areas of all panels together. [pixels]
constexpr int kSmallestAreas = 900, kLargestAreas = 3840;

int rounded(double length) {
  return static_cast<int>(std::lround(length));
}

int runsAcross(const scene::Scene& scene) {
  return scene.map->width * static_cast<int>(motionsOf(scene).size());
}

int scaleOf(const scene::Scene& scene) {
  return std::max(1, (kSmallestAreas + runsAcross(scene) - 1) / runsAcross(scene));
}

int strideOf(const scene::Scene& scene) {
  return std::max(1, (runsAcross(scene) + kLargestAreas - 1) / kLargestAreas);
}

double lettersOfMap(const scene::Scene& scene) {
  const double areas = 1.0 * runsAcross(scene) * scaleOf(scene) / strideOf(scene);
  return std::clamp(6 + 0.0105 * areas, 14.0, 36.0);
}

Axis axisOf(const scene::MapAxis& axis) {
  const bool isInDegrees =
      axis.kind == scene::AxisKind::SpinLongitude || axis.kind == scene::AxisKind::SpinLatitude;
  return {nameOf(axis), axis.from, axis.to, axis.scale, isInDegrees};
}

}  // namespace

MapLayout::MapLayout(const scene::Scene& scene, const overlay::Typesetter& type, int leastWidth)
    : scale(scaleOf(scene)), stride(strideOf(scene)), look(lettersOfMap(scene), true) {
  const scene::MapSettings& map = *scene.map;
  const int panels = static_cast<int>(motionsOf(scene).size());
  const double em = look.letters;
  Area area{{0, 0, 1.0 * ((map.width + stride - 1) / stride * scale),
             1.0 * ((map.height + stride - 1) / stride * scale)},
            axisOf(map.x),
            axisOf(map.y)};
  area.chooseTicks(look);

  // Across
  const int margin = rounded(2.4 * em), gap = rounded(3.2 * em);
  const int areaWidth = static_cast<int>(area.box.width);
  int left = margin + widestLabel(area.yTicks, look, type) + rounded(1.0 * em);
  textWidth = panels * areaWidth + (panels - 1) * gap;
  width = std::max(left + textWidth + margin, leastWidth);
  width += width % 2;
  left = width - margin - textWidth;

  // From the top to the bottom
  const auto below = [&](const std::string& text, const TextStyle& style) {
    return text.empty() ? 0 : type.measure(text, style, textWidth).height;
  };
  titleTop = margin;
  legendTop = titleTop + below(scene.title, look.title) + rounded(1.1 * em);
  axisNameTop = legendTop + rounded(3.3 * em);
  panelNameTop = axisNameTop + rounded(1.9 * em);
  area.box.y = panels > 1 ? panelNameTop + rounded(1.8 * em) : panelNameTop;
  for (int panel = 0; panel < panels; ++panel) {
    area.box.x = left + panel * (areaWidth + gap);
    areas.push_back(area);
  }
  xNameTop = static_cast<int>(area.box.bottom()) + rounded(2.1 * em);
  captionTop = xNameTop + rounded(2.5 * em);
  const int caption = below(scene.caption, look.caption);
  height = captionTop + caption + (caption > 0 ? margin : 0);
  height += height % 2;
}

}  // namespace rotatebook::plot
