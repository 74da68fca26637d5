#include "plot/map_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number_text.h"
#include "plot/map_colours.h"
#include "plot/plot.h"
#include "scene/key_rows.h"

namespace rotatebook::plot {
namespace {

using scene::Measure;

constexpr int kSmallestAreas = 900, kLargestAreas = 3840;  // of all panels together [pixels]
// Cairo draws 32,767 pixels at most, with what is around the areas.
constexpr int kHighestAreas = 8192;
constexpr int kMaxSteps = 64;  // of whole numbers in the legend
constexpr Colour kContourColour{0.97, 0.96, 0.93};

std::string labelOfScale(const scene::MapSettings& map) {
  const std::string label(rowOf(map.measure).label);
  const bool isCount = map.measure == Measure::HalfTurns;
  const bool isLargest = map.moment == scene::MapMoment::Largest && !isCount;
  return (isLargest ? "largest " : "") + label;
}

std::string neverText(const scene::MapSettings& map) {
  if (map.measure == Measure::DivergesAt) return "holds together";
  if (map.measure == Measure::FirstFlip) return "no flip";
  return "fewer than two flips";
}

std::string refusedText(const scene::MapSettings& map) {
  const auto isMoment = [](const scene::Axis& axis) {
    return axis.kind == scene::AxisKind::SmallestMoment ||
           axis.kind == scene::AxisKind::MiddleMoment;
  };
  return isMoment(map.x) || isMoment(map.y) ? "no such body" : "refused";
}

Axis mapAxis(const scene::Axis& axis) {
  const bool isInDegrees =
      axis.kind == scene::AxisKind::SpinLongitude || axis.kind == scene::AxisKind::SpinLatitude;
  return {nameOf(axis), axis.from, axis.to, axis.scale, isInDegrees};
}

/// Returns the colours of the values; those of whole numbers as steps.
ColourBar barOf(const scene::MapSettings& map, const MapColouring& colouring) {
  constexpr int kPixels = 512;
  const bool isInDegrees = labelOfScale(map).find("[degrees]") != std::string::npos;
  const bool isCount = map.measure == Measure::HalfTurns || map.measure == Measure::Regime;
  const bool isWhole = isCount && colouring.to() - colouring.from() <= kMaxSteps &&
                       colouring.scale() == scene::Scale::Linear;
  ColourBar bar{{"", colouring.from(), colouring.to(), colouring.scale(), isInDegrees},
                image::Image(kPixels, 1, image::PixelFormat::Rgb8)};
  if (isWhole) {
    constexpr double kTicks = 5;
    for (const Tick& tick : bar.axis.ticks(kTicks)) {
      if (std::floor(tick.value) == tick.value) bar.axis.words.push_back(tick);
    }
    bar.axis.from = std::ceil(colouring.from()) - 0.5;
    bar.axis.to = std::floor(colouring.to()) + 0.5;
  }
  for (int i = 0; i < kPixels; ++i) {
    const double share = (i + 0.5) / kPixels;
    const Rgb colour = isWhole
                           ? colouring.of(std::round(std::lerp(bar.axis.from, bar.axis.to, share)))
                           : colouring.at(share);
    putColour(colour, bar.colours.row(0) + 3 * static_cast<std::ptrdiff_t>(i));
  }
  return bar;
}

/// Returns the value of a mark; nothing of a run without a number.
std::string valueText(double value, const MapColouring& colouring) {
  constexpr int kDigits = 3;
  constexpr double kTiny = 1e-9;  // of the range of colours
  if (study::outcomeOf(value) != scene::Outcome::Value) return "";
  const bool isTiny = std::fabs(value) < kTiny * (colouring.to() - colouring.from());
  return ": " + roundedText(isTiny ? 0 : value, kDigits);
}

void fill(Panel& panel, std::size_t index, const study::MapResult& result,
          const scene::MapSettings& map, const MapColouring& colouring, int stride) {
  const std::vector<double>& values = result.values[index];
  panel.picture = mapPixels(values, map, colouring, stride);
  for (const double level : map.colours.contours) {
    for (const Point& point : contourOf(values, map.width, map.height, level)) {
      panel.lines.emplace_back(
          scene::numberWithin(map.x.from, map.x.to, (point.x() + 0.5) / map.width, map.x.scale),
          scene::numberWithin(map.y.from, map.y.to, (point.y() + 0.5) / map.height, map.y.scale));
    }
  }
  for (std::size_t i = 0; i < panel.marks.size(); ++i) {
    panel.marks[i].label += valueText(result.marks[i].values[index], colouring);
  }
}

/// Of so many runs across and up one is drawn.
int strideOf(const scene::Scene& scene) {
  const int across = scene.map->width * static_cast<int>(scene.motions.size());
  return std::max(1, (across + kLargestAreas - 1) / kLargestAreas);
}

/// Returns the plot of a scene's map, without what its runs show.
Plot emptyPlot(const scene::Scene& scene, int leastWidth) {
  const scene::MapSettings& map = *scene.map;
  Plot plot{scene.title, scene.caption, labelOfScale(map)};
  const int panels = static_cast<int>(scene.motions.size()), across = map.width * panels;
  const int stride = strideOf(scene);
  const int wanted = (kSmallestAreas + across - 1) / across;
  const int scale = std::max(1, std::min(wanted, kHighestAreas / map.height));
  plot.areaWidth = 1.0 * ((map.width + stride - 1) / stride * scale);
  plot.areaHeight = 1.0 * ((map.height + stride - 1) / stride * scale);
  plot.letters = std::clamp(6 + 0.0105 * across * scale / stride, 14.0, 36.0);
  plot.isDark = true;
  plot.leastWidth = leastWidth;
  for (const scene::Panel& motion : scene.motions) {
    Panel panel{motion.label, mapAxis(map.x), mapAxis(map.y), !plot.panels.empty()};
    panel.pen = {kContourColour, 0.09 * plot.letters, 0.7};
    for (const scene::MapMark& mark : map.marks)
      panel.marks.push_back({{mark.x, mark.y}, mark.label});
    plot.panels.push_back(panel);
  }
  return plot;
}

}  // namespace

void requireMapLetters(const scene::Scene& scene) {
  drawPlot(emptyPlot(scene, 0), lettersOf(scene));
}

Drawing drawMap(const study::MapResult& result, const scene::Scene& scene, int leastWidth) {
  const scene::MapSettings& map = *scene.map;
  const study::MapFacts facts = factsOf(result);
  const MapColouring colouring(map.colours, facts);
  Plot plot = emptyPlot(scene, leastWidth);
  if (facts.withValue() > 0) plot.bar = barOf(map, colouring);
  const auto add = [&](std::int64_t runs, const std::string& name, const Rgb& colour) {
    const Colour drawn{colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0};
    const Marker square{drawn, 4, 0.125, false, 0.5 * plot.letters};
    if (runs > 0) plot.legend.push_back({name, square, {}, false});
  };
  add(facts.never, neverText(map), kNeverColour);
  add(facts.diverged, "diverged", kDivergedColour);
  add(facts.refused, refusedText(map), kRefusedColour);
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    fill(plot.panels[i], i, result, map, colouring, strideOf(scene));
  }
  return drawPlot(plot, lettersOf(scene));
}

image::Image mapPicture(const study::MapResult& result, const scene::Scene& scene, int leastWidth) {
  return drawMap(result, scene, leastWidth).pixels();
}

std::vector<PlotFile> mapPlot(const study::MapResult& result, const scene::Scene& scene,
                              const std::vector<std::filesystem::path>& files) {
  return filesOf(drawMap(result, scene), files);
}

int mapWidth(const scene::Scene& scene) {
  return static_cast<int>(widthOf(emptyPlot(scene, 0), lettersOf(scene)));
}

}  // namespace rotatebook::plot
