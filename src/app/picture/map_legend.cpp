#include "picture/map_legend.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"

namespace rotatebook::picture {
namespace {

using overlay::Point;
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

overlay::Colour colourOf(const Rgb& rgb) {
  return {rgb.red / 255.0, rgb.green / 255.0, rgb.blue / 255.0};
}

/// Draws from left to right.
class Legend {
 public:
  Legend(const MapLayout& layout, const overlay::Typesetter& type, overlay::Canvas& canvas)
      : layout_(layout),
        styles_(layout.letters),
        type_(type),
        canvas_(canvas),
        x_(layout.plots.front().x) {}

  void write(const std::string& text, const overlay::TextStyle& style, double gapAfter) {
    const overlay::Layer layer = type_.draw(text, style, layout_.width);
    canvas_.write(layer, Point(x_, layout_.legendTop));
    x_ += layer.width + gapAfter * layout_.letters;
  }

  void chip(const Rgb& colour, const std::string& text) {
    const double em = layout_.letters;
    canvas_.roundedBox({x_, layout_.legendTop + 0.15 * em, em, em}, 0.2 * em, {colourOf(colour)});
    x_ += 1.45 * em;
    write(text, styles_.small, 1.6);
  }

  /// Paints the colours into the sheet; whole numbers as steps.
  void bar(const MapColouring& colouring, bool isWhole, bool isInDegrees, image::Image& sheet) {
    const double em = layout_.letters;
    const int left = static_cast<int>(x_), width = static_cast<int>(17 * em);
    const int top = layout_.legendTop + static_cast<int>(0.12 * em);
    const int height = static_cast<int>(1.05 * em);
    for (int x = 0; x < width; ++x) {
      const Rgb colour = colourAt(colouring, (x + 0.5) / width, isWhole);
      for (int y = top; y < top + height; ++y) {
        std::uint8_t* byte = sheet.row(y) + 3 * (left + x);
        byte[0] = colour.red;
        byte[1] = colour.green;
        byte[2] = colour.blue;
      }
    }
    ticks(colouring, isWhole, isInDegrees, {1.0 * left, 1.0 * top, 1.0 * width, 1.0 * height});
    x_ = left + width + 2.6 * em;
  }

  const MapStyles& styles() const { return styles_; }

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

  void ticks(const MapColouring& colouring, bool isWhole, bool isInDegrees,
             const overlay::Box& bar) {
    constexpr int kWanted = 5;
    const double em = layout_.letters;
    for (const Tick& tick :
         ticksOf(colouring.from(), colouring.to(), colouring.scale(), kWanted, isInDegrees)) {
      if (tick.label.empty() || (isWhole && std::floor(tick.value) != tick.value)) continue;
      const double x = bar.x + placeOf(colouring, tick.value, isWhole) * bar.width;
      const std::vector<Point> line{{x, bar.bottom()}, {x, bar.bottom() + 0.3 * em}};
      canvas_.line(line, {styles_.small.colour, 0.07 * em, 1, 0});
      const overlay::Layer label = type_.draw(tick.label, styles_.small, layout_.width);
      canvas_.write(label, Point(x - label.width / 2.0, bar.bottom() + 0.4 * em));
    }
  }

  const MapLayout& layout_;
  MapStyles styles_;
  const overlay::Typesetter& type_;
  overlay::Canvas& canvas_;
  double x_;
};

}  // namespace

void drawLegend(const scene::Scene& scene, const study::MapFacts& facts,
                const MapColouring& colouring, const MapLayout& layout,
                const overlay::Typesetter& type, overlay::Canvas& canvas, image::Image& sheet) {
  const scene::MapSettings& map = *scene.map;
  const bool isCount = map.measure == Measure::HalfTurns || map.measure == Measure::Regime;
  const bool isWhole = isCount && colouring.to() - colouring.from() <= kMaxSteps &&
                       colouring.scale() == scene::Scale::Linear;
  Legend legend(layout, type, canvas);
  legend.write(labelOfScale(map), legend.styles().bold, 1.2);
  const std::string label = labelOfScale(map);
  const bool isInDegrees = label.find("[degrees]") != label.npos;
  if (facts.withValue() > 0) legend.bar(colouring, isWhole, isInDegrees, sheet);
  if (facts.never > 0) legend.chip(kNeverColour, neverText(map));
  if (facts.diverged > 0) legend.chip(kDivergedColour, "diverged");
  if (facts.refused > 0) legend.chip(kRefusedColour, refusedText(map));
}

}  // namespace rotatebook::picture
