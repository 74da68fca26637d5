#include "plot/map_legend.h"

#include <array>
#include <cmath>
#include <string>

namespace rotatebook::plot {
namespace {

using scene::Measure;

constexpr int kMaxSteps = 64;  // of whole numbers that are drawn as such

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
  const auto isMoment = [](const scene::MapAxis& axis) {
    return axis.kind == scene::AxisKind::SmallestMoment ||
           axis.kind == scene::AxisKind::MiddleMoment;
  };
  return isMoment(map.x) || isMoment(map.y) ? "no such body" : "refused";
}

/// Draws from left to right.
class Legend {
 public:
  Legend(const MapLayout& layout, Drawing& drawing)
      : layout_(layout), em_(layout.look.letters), drawing_(drawing), x_(layout.areas[0].box.x) {}

  void write(const std::string& text, const TextStyle& style, double gapAfter) {
    x_ = drawing_.write(text, style, Point(x_, layout_.legendTop)).right() + gapAfter * em_;
  }

  void chip(const Rgb& colour, const std::string& text) {
    drawing_.roundedBox({x_, layout_.legendTop + 0.15 * em_, em_, em_}, 0.2 * em_,
                        {colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0});
    x_ += 1.45 * em_;
    write(text, layout_.look.small, 1.6);
  }

  /// Draws the colours; whole numbers as steps.
  void bar(const MapColouring& colouring, bool isWhole, bool isInDegrees) {
    const Box box{std::floor(x_), layout_.legendTop + std::floor(0.12 * em_), std::floor(17 * em_),
                  std::floor(1.05 * em_)};
    image::Image colours(static_cast<int>(box.width), 1, image::PixelFormat::Rgb8);
    for (int x = 0; x < colours.width(); ++x) {
      putColour(colourAt(colouring, (x + 0.5) / box.width, isWhole), colours.row(0) + 3 * x);
    }
    drawing_.picture(colours, box);
    ticks(colouring, isWhole, isInDegrees, box);
    x_ = box.right() + 2.6 * em_;
  }

 private:
  static double stepsOf(const MapColouring& colouring) {
    return std::floor(colouring.to()) - std::ceil(colouring.from()) + 1;
  }

  static Rgb colourAt(const MapColouring& colouring, double share, bool isWhole) {
    if (!isWhole) return colouring.palette().at(share);
    return colouring.of(std::ceil(colouring.from()) + std::floor(share * stepsOf(colouring)));
  }

  static double placeOf(const MapColouring& colouring, double value, bool isWhole) {
    if (!isWhole) return colouring.shareOf(value);
    return (value - std::ceil(colouring.from()) + 0.5) / stepsOf(colouring);
  }

  void ticks(const MapColouring& colouring, bool isWhole, bool isInDegrees, const Box& bar) {
    constexpr int kWanted = 5;
    for (const Tick& tick :
         ticksOf(colouring.from(), colouring.to(), colouring.scale(), kWanted, isInDegrees)) {
      if (tick.label.empty() || (isWhole && std::floor(tick.value) != tick.value)) continue;
      const double x = bar.x + placeOf(colouring, tick.value, isWhole) * bar.width;
      drawing_.line(std::array{Point(x, bar.bottom()), Point(x, bar.bottom() + 0.3 * em_)},
                    layout_.look.thin());
      drawing_.write(tick.label, layout_.look.small, {x, bar.bottom() + 0.4 * em_}, {0.5, 0});
    }
  }

  const MapLayout& layout_;
  double em_;
  Drawing& drawing_;
  double x_;
};

}  // namespace

void drawLegend(const scene::MapSettings& map, const study::MapFacts& facts,
                const MapColouring& colouring, const MapLayout& layout, Drawing& drawing) {
  const bool isCount = map.measure == Measure::HalfTurns || map.measure == Measure::Regime;
  const bool isWhole = isCount && colouring.to() - colouring.from() <= kMaxSteps &&
                       colouring.scale() == scene::Scale::Linear;
  const std::string label = labelOfScale(map);
  Legend legend(layout, drawing);
  legend.write(label, layout.look.bold, 1.2);
  const bool isInDegrees = label.find("[degrees]") != label.npos;
  if (facts.withValue() > 0) legend.bar(colouring, isWhole, isInDegrees);
  if (facts.never > 0) legend.chip(kNeverColour, neverText(map));
  if (facts.diverged > 0) legend.chip(kDivergedColour, "diverged");
  if (facts.refused > 0) legend.chip(kRefusedColour, refusedText(map));
}

}  // namespace rotatebook::plot
