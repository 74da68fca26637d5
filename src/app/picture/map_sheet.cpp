#include "picture/map_sheet.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "overlay/canvas.h"
#include "picture/map_colours.h"
#include "picture/map_contours.h"
#include "picture/map_layout.h"
#include "picture/map_legend.h"

namespace rotatebook::picture {
namespace {

using overlay::Box;
using overlay::Point;

constexpr Rgb kGround{15, 17, 21};
constexpr overlay::Colour kDark{0.04, 0.045, 0.06};
constexpr overlay::Colour kWhite{0.97, 0.96, 0.93};

void fillGround(image::Image& sheet) {
  for (int y = 0; y < sheet.height(); ++y) {
    std::uint8_t* byte = sheet.row(y);
    for (int x = 0; x < sheet.width(); ++x) {
      *byte++ = kGround.red;
      *byte++ = kGround.green;
      *byte++ = kGround.blue;
    }
  }
}

/// Draws one map's sheet.
class MapSheet {
 public:
  MapSheet(const study::MapResult& result, const scene::Scene& scene)
      : result_(result),
        scene_(scene),
        map_(*scene.map),
        facts_(factsOf(result)),
        colouring_(map_.colours, facts_),
        layout_(layOutMap(scene, type_)),
        styles_(layout_.letters),
        canvas_(layout_.width, layout_.height),
        sheet_(layout_.width, layout_.height, image::PixelFormat::Rgb8) {}

  image::Image draw() {
    fillGround(sheet_);
    for (std::size_t panel = 0; panel < layout_.plots.size(); ++panel) {
      paintRuns(panel);
      drawContours(panel);
      drawTicks(layout_.plots[panel], panel == 0);
      drawMarks(panel);
    }
    writeTexts();
    drawLegend(scene_, facts_, colouring_, layout_, type_, canvas_, sheet_);
    canvas_.layOver(sheet_);
    return std::move(sheet_);
  }

 private:
  void paintRuns(std::size_t panel) {
    const Box& plot = layout_.plots[panel];
    const std::vector<double>& values = result_.values[panel];
    const int width = static_cast<int>(plot.width), height = static_cast<int>(plot.height);
    for (int y = 0; y < height; ++y) {
      std::uint8_t* byte = sheet_.row(static_cast<int>(plot.y) + y) + 3 * static_cast<int>(plot.x);
      const int row = (height - 1 - y) / layout_.scale * layout_.stride;
      for (int x = 0; x < width; ++x) {
        const int column = x / layout_.scale * layout_.stride;
        const auto run = static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.width) +
                         static_cast<std::size_t>(column);
        const Rgb colour = colouring_.of(values[run]);
        *byte++ = colour.red;
        *byte++ = colour.green;
        *byte++ = colour.blue;
      }
    }
  }

  void drawContours(std::size_t panel) {
    const Box& plot = layout_.plots[panel];
    const double each = 1.0 * layout_.scale / layout_.stride;
    for (const double level : map_.colours.contours) {
      std::vector<Point> pairs = contourOf(result_.values[panel], map_.width, map_.height, level);
      for (Point& point : pairs) {
        point = Point(plot.x + (point.x() + 0.5) * each, plot.bottom() - (point.y() + 0.5) * each);
      }
      if (!pairs.empty()) canvas_.lines(pairs, {kWhite, 0.09 * layout_.letters, 0.7, 0});
    }
  }

  void drawTicks(const Box& plot, bool hasYLabels) {
    const double length = layout_.tickLength(), em = layout_.letters;
    const overlay::Pen pen{styles_.small.colour, 0.07 * em, 1, 0};
    for (const Tick& tick : layout_.xTicks) {
      const double x =
          plot.x + plot.width * scene::shareOf(tick.value, map_.x.from, map_.x.to, map_.x.scale);
      const double end = tick.label.empty() ? 0.5 * length : length;
      canvas_.line(std::vector<Point>{{x, plot.bottom() + 1}, {x, plot.bottom() + 1 + end}}, pen);
      if (tick.label.empty()) continue;
      const overlay::Layer label = type_.draw(tick.label, styles_.small, layout_.width);
      canvas_.write(label, Point(x - label.width / 2.0, plot.bottom() + 1.25 * length));
    }
    for (const Tick& tick : layout_.yTicks) {
      const double y = plot.bottom() - plot.height * scene::shareOf(tick.value, map_.y.from,
                                                                    map_.y.to, map_.y.scale);
      const double end = tick.label.empty() ? 0.5 * length : length;
      canvas_.line(std::vector<Point>{{plot.x - 1, y}, {plot.x - 1 - end, y}}, pen);
      if (tick.label.empty() || !hasYLabels) continue;
      const overlay::Layer label = type_.draw(tick.label, styles_.small, layout_.width);
      canvas_.write(label, Point(plot.x - 1.6 * length - label.width, y - label.height / 2.0));
    }
  }

  /// Returns the value of a mark; nothing of a run without a number.
  std::string valueText(double value) const {
    constexpr int kDigits = 3;
    constexpr double kTiny = 1e-9;  // of the range of colours
    if (study::outcomeOf(value) != scene::Outcome::Value) return "";
    const bool isTiny = std::fabs(value) < kTiny * (colouring_.to() - colouring_.from());
    return "  " + roundedText(isTiny ? 0 : value, kDigits);
  }

  void drawMarks(std::size_t panel) {
    const Box& plot = layout_.plots[panel];
    const double em = layout_.letters, radius = 0.32 * em;
    overlay::TextStyle style = styles_.bold;
    style.halo = 0.16 * em;
    std::vector<Box> taken;
    for (const study::MarkedValue& marked : result_.marks) {
      const Point at(
          plot.x + plot.width * scene::shareOf(marked.mark.x, map_.x.from, map_.x.to, map_.x.scale),
          plot.bottom() -
              plot.height * scene::shareOf(marked.mark.y, map_.y.from, map_.y.to, map_.y.scale));
      canvas_.disc(at, radius + 0.14 * em, {kDark, 0.9});
      canvas_.disc(at, radius, {kWhite});
      canvas_.disc(at, 0.45 * radius, {kDark});
      const overlay::Layer label =
          type_.draw(marked.mark.label + valueText(marked.values[panel]), style, layout_.width);
      const Point place = placeOf(label, at, plot, taken);
      canvas_.write(label, place);
      taken.push_back(overlay::boxOf(label, place));
    }
  }

  /// Returns a place beside the point: the first of several that is within the plot and free.
  Point placeOf(const overlay::Layer& label, const Point& at, const Box& plot,
                const std::vector<Box>& taken) const {
    const Box box = overlay::boxOf(label);
    const double gap = 0.75 * layout_.letters;
    const double right = at.x() + gap, left = at.x() - gap - box.width;
    const double middle = at.y() - box.height / 2, below = at.y() + 0.4 * gap;
    const double above = at.y() - 0.4 * gap - box.height;
    const std::vector<Point> places{
        {right, middle},
        {left, middle},
        {right, below},
        {left, below},
        {right, above},
        {left, above},
        {at.x() - box.width / 2, at.y() + gap},
    };
    for (const Point& place : places) {
      if (isFree(box.moved(place), plot, taken)) return place;
    }
    return places.front();
  }

  void write(const std::string& text, const overlay::TextStyle& style, double x, double y) {
    if (!text.empty()) canvas_.write(type_.draw(text, style, layout_.textWidth), Point(x, y));
  }

  void writeTexts() {
    const double left = layout_.plots.front().x, right = layout_.plots.back().right();
    write(scene_.title, styles_.title, left, layout_.titleTop);
    write("↑ " + nameOf(map_.y), styles_.name, left, layout_.axisNameTop);
    const overlay::Layer name = type_.draw(nameOf(map_.x) + " →", styles_.name, layout_.textWidth);
    canvas_.write(name, Point(right - name.width, layout_.xNameTop));
    write(scene_.caption, styles_.caption, left, layout_.captionTop);
    for (std::size_t panel = 0; panel < layout_.plots.size(); ++panel) {
      write(result_.labels[panel], styles_.bold, layout_.plots[panel].x, layout_.panelNameTop);
    }
  }

  const study::MapResult& result_;
  const scene::Scene& scene_;
  const scene::MapSettings& map_;
  study::MapFacts facts_;
  overlay::Typesetter type_;
  MapColouring colouring_;
  MapLayout layout_;
  MapStyles styles_;
  overlay::Canvas canvas_;
  image::Image sheet_;
};

}  // namespace

void requireMapText(const scene::Scene& scene) {
  constexpr int kWidth = 1000;
  const overlay::Typesetter type;
  const MapStyles styles(14);
  std::vector<std::string> texts{scene.title, scene.caption, nameOf(scene.map->x),
                                 nameOf(scene.map->y)};
  for (const scene::MapMark& mark : scene.map->marks) texts.push_back(mark.label);
  for (const scene::Panel& panel : motionsOf(scene)) texts.push_back(panel.label);
  for (const std::string& text : texts) {
    if (!text.empty()) type.draw(text, styles.name, kWidth);
  }
}

image::Image onGround(const image::Image& sheet, int width) {
  image::Image wide(width, sheet.height() + sheet.height() % 2, image::PixelFormat::Rgb8);
  fillGround(wide);
  paste(sheet.view(), width - sheet.width(), 0, wide);
  return wide;
}

int mapSheetWidth(const scene::Scene& scene) {
  return layOutMap(scene, overlay::Typesetter()).width;
}

image::Image drawMapSheet(const study::MapResult& result, const scene::Scene& scene) {
  return MapSheet(result, scene).draw();
}

}  // namespace rotatebook::picture
