#include "plot/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace rotatebook::plot {
namespace {

constexpr double kLeastPanel = 400;                             // width of a panel [pixels]
constexpr double kMargin = 2.4, kGap = 3, kRow = 1.8;           // [letters]
constexpr double kSample = 2.6, kBarWidth = 17, kBarRow = 3.3;  // of the legend [letters]
constexpr Colour kDark{0.04, 0.045, 0.06}, kWhite{0.97, 0.96, 0.93};

constexpr Colour rgb(int hex) {
  return {(hex >> 16) / 255.0, (hex >> 8 & 0xff) / 255.0, (hex & 0xff) / 255.0};
}

constexpr double kDown = 0.5, kLevel = 0.125;  // turned: a triangle's corner, a square's edge
constexpr std::array<Marker, 14> kMarkers{{{rgb(0x000000)},
                                           {rgb(0xd55e00), 3},
                                           {rgb(0x7f7f7f), 0, 0, true},
                                           {rgb(0xe69f00), 3, 0, true},
                                           {rgb(0x0072b2), 4, kLevel},
                                           {rgb(0x009e73), 3, kDown},
                                           {rgb(0x56b4e9), 4, kLevel, true},
                                           {rgb(0xcc79a7), 4},
                                           {rgb(0x882255), 4, 0, true},
                                           {rgb(0x332288), 5},
                                           {rgb(0xaa4499), 5, kDown},
                                           {rgb(0x117733), 5, 0, true},
                                           {rgb(0x999933), 3, kDown, true},
                                           {rgb(0xcc6677), 5, kDown, true}}};

/// Draws a marker, whose area is that of the disc, so that no shape looks larger.
void drawMarker(const Marker& marker, const Point& at, const Look& look, Drawing& drawing) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const int count = marker.corners == 0 ? 24 : marker.corners;
  const double radius = marker.radius * std::sqrt(kTurn / (count * std::sin(kTurn / count)));
  std::vector<Point> corners;
  for (int i = 0; i <= count; ++i) {
    const double angle = kTurn * (1.0 * i / count + marker.turned);
    corners.push_back(at + radius * Point(std::sin(angle), -std::cos(angle)));
  }
  drawing.canvas().area(corners, {marker.isOpen ? look.ground : marker.colour});
  drawing.canvas().line(corners, {marker.colour, 1.6});
}

/// Returns a place for a label beside a point: the first of several within the area and free.
Point placeBeside(const Point& at, const Box& label, double gap, const Box& area,
                  const std::vector<Box>& taken) {
  const double right = at.x() + gap, left = at.x() - gap - label.width;
  const double middle = at.y() - label.height / 2, below = at.y() + 0.4 * gap;
  const double above = at.y() - 0.4 * gap - label.height;
  const std::array<Point, 7> places{{{right, middle},
                                     {left, middle},
                                     {right, below},
                                     {left, below},
                                     {right, above},
                                     {left, above},
                                     {at.x() - label.width / 2, at.y() + gap}}};
  const auto found = std::ranges::find_if(
      places, [&](const Point& place) { return isFree(label.moved(place), area, taken); });
  return found == places.end() ? places.front() : *found;
}

/// The places of a plot's parts. [pixels]
struct Layout {
  Layout(const Plot& of, const overlay::Typesetter& letters)
      : plot(of), type(letters), look(of.letters, of.isDark), em(of.letters) {
    placeAcross();
    legendTop = std::round(kMargin * em) + heightOf(plot.title, look.title) +
                std::round((plot.title.empty() ? 0 : 1.1) * em);
    placeLegend();
    placeDown();
  }

  /// An item of the legend, and its top left.
  struct Item {
    const Series* series;
    Point at;
  };

  double heightOf(const std::string& text, const TextStyle& style) const {
    return boxOf(type, text, style, textWidth).height;
  }
  double widthOf(const std::string& text, const TextStyle& style) const {
    return boxOf(type, text, style).width;
  }

  void placeAcross() {
    const auto count = static_cast<double>(plot.panels.size());
    const double margin = std::round(kMargin * em);
    std::vector<double> labels;
    double taken = 2 * margin + (count - 1) * std::round(kGap * em);
    for (const Panel& panel : plot.panels) {
      Area area{{0, 0, plot.areaWidth, plot.areaHeight}, panel.x, panel.y};
      area.chooseTicks(look);
      labels.push_back(0);
      if (!panel.sharesY) {
        for (const Tick& tick : area.yTicks) {
          labels.back() = std::max(labels.back(), widthOf(tick.label, look.small));
        }
        labels.back() += std::round(em);
      }
      taken += labels.back();
      areas.push_back(area);
    }
    width = std::max(plot.leastWidth, taken + count * plot.areaWidth);
    if (plot.areaWidth == 0) width = std::max(width, count * kLeastPanel);
    width = 2 * std::ceil(width / 2);
    double right = width - margin;
    for (std::size_t i = areas.size(); i-- > 0;) {
      Area& area = areas[i];
      if (plot.areaWidth == 0) area.box.width = (width - taken) / count;
      area.box.x = right - area.box.width;
      area.chooseTicks(look);
      right = area.box.x - labels[i] - std::round(kGap * em);
    }
    textWidth = width - margin - areas.front().box.x;
  }

  std::vector<const Series*> named() const {
    std::vector<const Series*> all;
    const auto add = [&](const Series& series) {
      const bool isNew = std::ranges::none_of(
          all, [&](const Series* other) { return other->name == series.name; });
      if (isNew && !series.name.empty()) all.push_back(&series);
    };
    for (const Panel& panel : plot.panels) std::ranges::for_each(panel.series, add);
    std::ranges::for_each(plot.legend, add);
    return all;
  }

  /// Places the items in rows below the title of the legend, or beside its bar.
  void placeLegend() {
    const double left = areas.front().box.x;
    double x = left, y = legendTop;
    const auto advance = [&](double item) {
      x += item + 1.6 * em;
      legendBottom = y + (plot.bar && y == legendTop ? kBarRow : kRow) * em;
    };
    legendBottom = legendTop;
    if (!plot.legendTitle.empty()) advance(widthOf(plot.legendTitle, look.bold));
    bar = {std::floor(x), legendTop + std::floor(0.12 * em), std::floor(kBarWidth * em),
           std::floor(1.05 * em)};
    if (plot.bar) advance(bar.width + em);
    for (const Series* series : named()) {
      const double item = kSample * em + widthOf(series->name, look.small);
      if (x > left && x + item > left + textWidth) {
        x = left;
        y = legendBottom;
      }
      items.push_back({series, {x, y}});
      advance(item);
    }
    if (legendBottom > legendTop && !plot.bar) legendBottom += 0.6 * em;
  }

  std::string yName(std::size_t i) const {
    return plot.panels[i].sharesY ? "" : "↑ " + plot.panels[i].y.name;
  }

  void placeDown() {
    double names = 0, labels = 2.1 * em;
    bool hasPanelNames = false;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      const Panel& panel = plot.panels[i];
      hasPanelNames = hasPanelNames || !panel.name.empty();
      names = std::max(names, boxOf(type, yName(i), look.name, areas[i].box.width).height);
      for (const Tick& word : panel.x.words) {
        const Box box = boxOf(type, word.label, look.small, areas[i].labelRoom());
        labels = std::max(labels, em + box.height);
      }
    }
    yNameBottom = std::round(legendBottom + names);
    const double top = yNameBottom + std::round((hasPanelNames ? 0.6 + kRow : 0.6) * em);
    for (Area& area : areas) area.box.y = top;
    xNameTop = top + plot.areaHeight + std::round(labels);
    captionTop = xNameTop + std::round((plot.caption.empty() ? 1.3 : 2.5) * em);
    height = 2 * std::ceil((captionTop + heightOf(plot.caption, look.caption) + kMargin * em) / 2);
  }

  const Plot& plot;
  const overlay::Typesetter& type;
  Look look;
  double em;
  double width = 0, height = 0, textWidth = 0;
  double legendTop = 0, legendBottom = 0, yNameBottom = 0, xNameTop = 0, captionTop = 0;
  Box bar{};
  std::vector<Item> items{};
  std::vector<Area> areas{};
};

void drawLegend(const Plot& plot, const Layout& at, Drawing& drawing) {
  const double em = at.em;
  drawing.write(plot.legendTitle, at.look.bold, {at.areas.front().box.x, at.legendTop});
  for (const auto& [series, place] : at.items) {
    const double middle = place.y() + 0.65 * em, end = place.x() + (kSample - 0.6) * em;
    if (series->hasLine) {
      drawing.canvas().line(std::array{Point(place.x(), middle), Point(end, middle)},
                            {series->marker.colour, 1.6});
    }
    if (series->hasMarkers)
      drawMarker(series->marker, {(place.x() + end) / 2, middle}, at.look, drawing);
    drawing.write(series->name, at.look.small, {place.x() + kSample * em, middle}, {0, 0.5});
  }
  if (!plot.bar) return;
  constexpr double kTicks = 5;
  drawing.picture(plot.bar->colours, at.bar);
  for (const Tick& tick : plot.bar->axis.ticks(kTicks)) {
    if (tick.label.empty()) continue;
    const Point top(at.bar.x + plot.bar->axis.shareOf(tick.value) * at.bar.width, at.bar.bottom());
    drawing.canvas().line(std::array{top, Point(top.x(), top.y() + 0.3 * em)}, at.look.thin());
    drawing.write(tick.label, at.look.small, {top.x(), top.y() + 0.4 * em}, {0.5, 0});
  }
}

void drawMarks(const Panel& panel, const Area& area, const Look& look, Drawing& drawing) {
  const double em = look.letters, radius = 0.32 * em;
  TextStyle style = look.bold;
  style.halo = 0.16 * em;
  style.colour = kWhite;
  std::vector<Box> taken;
  for (const Mark& mark : panel.marks) {
    const Point at = area.placeOf(mark.at);
    drawing.canvas().disc(at, radius + 0.14 * em, {kDark, 0.9});
    drawing.canvas().disc(at, radius, {kWhite});
    drawing.canvas().disc(at, 0.45 * radius, {kDark});
    const Box label = boxOf(drawing.type(), mark.label, style);
    taken.push_back(
        drawing.write(mark.label, style, placeBeside(at, label, 0.75 * em, area.box, taken)));
  }
}

void drawPanel(const Panel& panel, const Area& area, const Look& look, Drawing& drawing) {
  const Box& box = area.box;
  overlay::Canvas& canvas = drawing.canvas();
  const auto placesOf = [&](const std::vector<Point>& points) {
    std::vector<Point> places;
    for (const Point& point : points) places.push_back(area.placeOf(point));
    return places;
  };
  if (panel.picture) drawing.picture(*panel.picture, box);
  drawAxes(area, look, !panel.sharesY, !panel.picture, drawing);
  if (!panel.picture) {
    const Point topLeft(box.x, box.y), bottomRight(box.right(), box.bottom());
    canvas.line(std::array{topLeft, Point(box.right(), box.y), bottomRight,
                           Point(box.x, box.bottom()), topLeft},
                look.thin());
  }
  canvas.lines(placesOf(panel.lines), panel.pen);
  for (const Series& series : panel.series) {
    const std::vector<Point> places = placesOf(series.points);
    if (series.hasLine) canvas.line(places, {series.marker.colour, 1.6});
    if (!series.hasMarkers) continue;
    for (const Point& place : places) drawMarker(series.marker, place, look, drawing);
  }
  drawMarks(panel, area, look, drawing);
}

}  // namespace

const Marker& markerOf(std::size_t number) {
  return kMarkers[number % kMarkers.size()];
}

Drawing drawPlot(const Plot& plot, overlay::Typesetter type) {
  const Layout at(plot, type);
  Drawing drawing(at.width, at.height, at.look.ground, std::move(type));
  const double left = at.areas.front().box.x, em = at.em;
  drawing.write(plot.title, at.look.title, {left, std::round(kMargin * em)}, {0, 0}, at.textWidth);
  drawLegend(plot, at, drawing);
  for (std::size_t i = 0; i < at.areas.size(); ++i) {
    const Panel& panel = plot.panels[i];
    const Box& box = at.areas[i].box;
    drawPanel(panel, at.areas[i], at.look, drawing);
    drawing.write(at.yName(i), at.look.name, {box.x, at.yNameBottom}, {0, 1}, box.width);
    drawing.write(panel.name, at.look.bold, {box.x, box.y - 0.4 * em}, {0, 1}, box.width);
    const bool isLast = i + 1 == at.areas.size() || plot.panels[i + 1].x.name != panel.x.name;
    if (!isLast) continue;
    drawing.write(panel.x.name + " →", at.look.name, {box.right(), at.xNameTop}, {1, 0},
                  at.textWidth);
  }
  drawing.write(plot.caption, at.look.caption, {left, at.captionTop}, {0, 0}, at.textWidth);
  return drawing;
}

double widthOf(const Plot& plot, const overlay::Typesetter& type) {
  return Layout(plot, type).width;
}

}  // namespace rotatebook::plot
