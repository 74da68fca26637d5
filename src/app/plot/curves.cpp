#include "plot/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace rotatebook::plot {
namespace {

constexpr double kLetters = 15, kAreaHeight = 400;            // [pixels]
constexpr double kLeastWidth = 1200, kLeastPanelWidth = 400;  // [pixels]
constexpr double kMargin = 2 * kLetters, kGap = 2 * kLetters;

constexpr Colour rgb(int hex) {
  return {(hex >> 16) / 255.0, (hex >> 8 & 0xff) / 255.0, (hex & 0xff) / 255.0};
}

constexpr double kDown = 0.5, kLevel = 0.125;  // turned: a triangle's corner, a square's edge
constexpr std::array<Marker, 16> kMarkers{{{rgb(0x000000)},
                                           {rgb(0xd55e00), 3},
                                           {rgb(0x7f7f7f), 0, 0, true},
                                           {rgb(0xe69f00), 3, 0, true},
                                           {rgb(0x0072b2), 4, kLevel},
                                           {rgb(0x009e73), 3, kDown},
                                           {rgb(0x56b4e9), 4, kLevel, true},
                                           {rgb(0xcc79a7), 4},
                                           {rgb(0x882255), 4, 0, true},
                                           {rgb(0x332288), 5},
                                           {rgb(0x0072b2), 4, kLevel},
                                           {rgb(0x009e73), 3, kDown},
                                           {rgb(0xaa4499), 5, kDown},
                                           {rgb(0x117733), 5, 0, true},
                                           {rgb(0x999933), 3, kDown, true},
                                           {rgb(0xcc6677), 5, kDown, true}}};

/// Returns the corners; the area is that of the disc, so that no shape looks larger.
std::vector<Point> cornersOf(const Marker& marker, const Point& at) {
  const int count = marker.corners == 0 ? 24 : marker.corners;
  const double turn = 2 * std::numbers::pi;
  const double radius = marker.radius * std::sqrt(turn / (count * std::sin(turn / count)));
  std::vector<Point> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = turn * (1.0 * i / count + marker.turned);
    corners.push_back(at + radius * Point(std::sin(angle), -std::cos(angle)));
  }
  return corners;
}

void drawMarker(const Marker& marker, const Point& at, const Look& look, Drawing& drawing) {
  std::vector<Point> corners = cornersOf(marker, at);
  drawing.area(corners, marker.isOpen ? look.ground : marker.colour);
  corners.push_back(corners.front());
  drawing.line(corners, {marker.colour, 1.6});
}

/// Draws one plot.
class CurvesDrawing {
 public:
  CurvesDrawing(const CurvesPlot& plot, overlay::Typesetter type)
      : plot_(plot), type_(std::move(type)), look_(kLetters, false) {}

  Drawing draw() {
    layOut();
    Drawing drawing(width_, height_, look_.ground, std::move(type_));
    drawing.write(plot_.title, look_.title, {areas_.front().box.x, kMargin}, {0, 0}, textWidth());
    drawing.write(plot_.note, look_.small, {areas_.front().box.x, noteTop_}, {0, 0}, textWidth());
    for (std::size_t i = 0; i < areas_.size(); ++i) drawPanel(i, drawing);
    drawLegend(drawing);
    return drawing;
  }

 private:
  overlay::TextSize sizeOf(const std::string& text, const TextStyle& style,
                           double width = 1e4) const {
    return text.empty() ? overlay::TextSize{} : type_.measure(text, style, static_cast<int>(width));
  }

  std::vector<const Series*> named() const {
    std::vector<const Series*> all;
    for (const CurvesPanel& panel : plot_.panels) {
      for (const Series& series : panel.series) {
        const bool isNew = std::ranges::none_of(
            all, [&](const Series* other) { return other->name == series.name; });
        if (isNew && !series.name.empty()) all.push_back(&series);
      }
    }
    return all;
  }

  double sampleWidth() const { return 2.6 * look_.letters; }
  double textWidth() const { return width_ - kMargin - areas_.front().box.x; }

  double legendWidth() const {
    const std::vector<const Series*> all = named();
    if (all.empty()) return 0;
    double widest = sizeOf(plot_.legendTitle, look_.small).width - sampleWidth();
    for (const Series* series : all) {
      widest = std::max(widest, 1.0 * sizeOf(series->name, look_.name).width);
    }
    return std::min(sampleWidth() + widest, kLegendRoom) + kGap;
  }

  /// Sets the places of the areas from the left to the right, then from the top to the bottom.
  void layOut() {
    const auto count = static_cast<double>(plot_.panels.size());
    width_ = std::max(kLeastWidth, legendWidth() + count * kLeastPanelWidth);
    double taken = 2 * kMargin + legendWidth() + (count - 1) * kGap;
    std::vector<double> labels;
    for (const CurvesPanel& panel : plot_.panels) {
      Area area{{0, 0, 0, kAreaHeight}, panel.x, panel.y};
      area.chooseTicks(look_);
      labels.push_back(panel.sharesY ? 0 : widestLabel(area.yTicks, look_, type_) + look_.letters);
      taken += labels.back();
      areas_.push_back(area);
    }
    double x = kMargin;
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      areas_[i].box.x = x + labels[i];
      areas_[i].box.width = (width_ - taken) / count;
      areas_[i].chooseTicks(look_);
      x = areas_[i].box.right() + kGap;
    }
    noteTop_ = kMargin + sizeOf(plot_.title, look_.title, textWidth()).height + 0.3 * look_.letters;
    double names = 0;
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      names = std::max(names, 1.0 * sizeOf(yName(i), look_.name, areas_[i].box.width).height);
    }
    top_ = noteTop_ + sizeOf(plot_.note, look_.small, textWidth()).height + 1.2 * look_.letters +
           names + 0.7 * look_.letters;
    double below = 0;
    for (Area& area : areas_) {
      area.box.y = top_;
      below = std::max(below, labelsHeight(area));
    }
    xNameTop_ = top_ + kAreaHeight + below;
    height_ = std::ceil(xNameTop_ + 1.3 * look_.letters + kMargin);
  }

  double labelsHeight(const Area& area) const {
    double height = 2.1 * look_.letters;
    for (const Tick& word : area.x.words) {
      const double room = area.box.width / static_cast<double>(area.x.words.size());
      height = std::max(height, look_.letters + sizeOf(word.label, look_.small, room).height);
    }
    return height;
  }

  std::string yName(std::size_t i) const {
    return plot_.panels[i].sharesY ? "" : "↑ " + plot_.panels[i].y.name;
  }
  void drawPanel(std::size_t i, Drawing& drawing) const {
    const CurvesPanel& panel = plot_.panels[i];
    const Area& area = areas_[i];
    const Box& box = area.box;
    drawAxes(area, look_, {.hasYLabels = !panel.sharesY, .hasGrid = true}, drawing);
    drawing.line(
        std::array{Point(box.x, box.y), Point(box.right(), box.y), Point(box.right(), box.bottom()),
                   Point(box.x, box.bottom()), Point(box.x, box.y)},
        look_.thin());
    std::vector<Point> guides;
    for (const Point& end : panel.guides) guides.push_back(area.placeOf(end.x(), end.y()));
    drawing.lines(guides, {{0.66, 0.66, 0.66}, 1});
    for (const Series& series : panel.series) drawSeries(series, area, drawing);
    drawing.write(yName(i), look_.name, {box.x, top_ - 0.7 * look_.letters}, {0, 1},
                  areas_[i].box.width);
    drawing.write(panel.x.name + " →", look_.name, {box.right(), xNameTop_}, {1, 0}, box.width);
  }

  void drawSeries(const Series& series, const Area& area, Drawing& drawing) const {
    std::vector<Point> places;
    for (const Point& point : series.points) places.push_back(area.placeOf(point.x(), point.y()));
    if (series.hasLine) drawing.line(places, {series.marker.colour, 1.6});
    if (!series.hasMarkers) return;
    for (const Point& place : places) drawMarker(series.marker, place, look_, drawing);
  }

  void drawLegend(Drawing& drawing) const {
    const double left = areas_.back().box.right() + kGap, row = 1.7 * look_.letters;
    double y = top_;
    if (!named().empty() && !plot_.legendTitle.empty()) {
      const double room = kLegendRoom;
      y = drawing.write(plot_.legendTitle, look_.small, {left, y}, {0, 0}, room).bottom() +
          0.5 * look_.letters;
    }
    for (const Series* series : named()) {
      const double middle = y + row / 2, end = left + sampleWidth() - 0.6 * look_.letters;
      if (series->hasLine) {
        drawing.line(std::array{Point(left, middle), Point(end, middle)},
                     {series->marker.colour, 1.6});
      }
      if (series->hasMarkers)
        drawMarker(series->marker, {(left + end) / 2, middle}, look_, drawing);
      const Box box = drawing.write(series->name, look_.name, {left + sampleWidth(), middle},
                                    {0, 0.5}, kLegendRoom - sampleWidth());
      y = std::max(y + row, box.bottom());
    }
  }

  static constexpr double kLegendRoom = 260;  // [pixels]

  const CurvesPlot& plot_;
  overlay::Typesetter type_;
  Look look_;
  std::vector<Area> areas_;
  double width_ = 0, height_ = 0, noteTop_ = 0, top_ = 0, xNameTop_ = 0;
};

}  // namespace

const Marker& markerOf(std::size_t number) {
  return kMarkers[number % kMarkers.size()];
}

Drawing drawCurves(const CurvesPlot& plot, overlay::Typesetter type) {
  return CurvesDrawing(plot, std::move(type)).draw();
}

}  // namespace rotatebook::plot
