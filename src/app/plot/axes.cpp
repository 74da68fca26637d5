#include <algorithm>
#include <array>
#include <cmath>

#include "plot/plot.h"

namespace rotatebook::plot {
namespace {

constexpr Colour kNight{15 / 255.0, 17 / 255.0, 21 / 255.0}, kPaper{1, 1, 1};

// Of a tick, in letters.
constexpr double kTickLength = 0.4;

double lengthOf(const Tick& tick, const Look& look) {
  return (tick.label.empty() ? 0.5 : 1) * kTickLength * look.letters;
}

void drawXTicks(const Area& area, const Look& look, bool hasGrid, Drawing& drawing) {
  const Box& box = area.box;
  double end = 0;
  for (const Tick& tick : area.xTicks) {
    const double x = box.x + box.width * area.x.shareOf(tick.value), top = box.bottom() + 1;
    if (hasGrid && !tick.label.empty()) {
      drawing.canvas().line(std::array{Point(x, box.y), Point(x, box.bottom())}, {look.grid, 1});
    }
    drawing.canvas().line(std::array{Point(x, top), Point(x, top + lengthOf(tick, look))},
                          look.thin());
    const Box label = boxOf(drawing.type(), tick.label, look.small, area.labelRoom());
    if (tick.label.empty() || x - label.width / 2 < end + 0.3 * look.letters) continue;
    const Point place(x, box.bottom() + 1.6 * kTickLength * look.letters);
    end = drawing.write(tick.label, look.small, place, {0.5, 0}, area.labelRoom()).right();
  }
}

void drawYTicks(const Area& area, const Look& look, bool hasLabels, bool hasGrid,
                Drawing& drawing) {
  const Box& box = area.box;
  for (const Tick& tick : area.yTicks) {
    const double y = box.bottom() - box.height * area.y.shareOf(tick.value), right = box.x - 1;
    if (hasGrid && !tick.label.empty()) {
      drawing.canvas().line(std::array{Point(box.x, y), Point(box.right(), y)}, {look.grid, 1});
    }
    drawing.canvas().line(std::array{Point(right, y), Point(right - lengthOf(tick, look), y)},
                          look.thin());
    if (!hasLabels) continue;
    drawing.write(tick.label, look.small, {box.x - 1.6 * kTickLength * look.letters, y}, {1, 0.5});
  }
}

}  // namespace

Look::Look(double size, bool isDark) : letters(size) {
  const Colour bright = isDark ? Colour{0.97, 0.96, 0.93} : Colour{0.07, 0.07, 0.09};
  const Colour text = isDark ? Colour{0.86, 0.86, 0.84} : Colour{0.16, 0.16, 0.19};
  ground = isDark ? kNight : kPaper;
  grid = isDark ? Colour{0.2, 0.2, 0.22} : Colour{0.9, 0.9, 0.9};
  quiet = isDark ? Colour{0.66, 0.67, 0.68} : Colour{0.36, 0.36, 0.39};
  title = {1.7 * size, true, bright};
  name = {size, false, text};
  bold = {size, true, bright};
  small = {0.88 * size, false, quiet};
  caption = {1.04 * size, false, text};
}

std::vector<Tick> Axis::ticks(double wanted) const {
  if (!words.empty()) return words;
  return ticksOf(from, to, scale, std::max(2, static_cast<int>(std::lround(wanted))), isInDegrees);
}

void Area::chooseTicks(const Look& look) {
  constexpr double kXRoom = 5.5, kYRoom = 4.5;  // of a label, in letters
  xTicks = x.ticks(box.width / (kXRoom * look.letters));
  yTicks = y.ticks(box.height / (kYRoom * look.letters));
}

Point Area::placeOf(const Point& point) const {
  return {box.x + box.width * x.shareOf(point.x()),
          box.bottom() - box.height * y.shareOf(point.y())};
}

double Area::labelRoom() const {
  return x.words.empty() ? 1e4 : box.width / static_cast<double>(x.words.size());
}

void drawAxes(const Area& area, const Look& look, bool hasYLabels, bool hasGrid, Drawing& drawing) {
  drawXTicks(area, look, hasGrid, drawing);
  drawYTicks(area, look, hasYLabels, hasGrid, drawing);
}

}  // namespace rotatebook::plot
