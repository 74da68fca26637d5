#include "plot/map_plot.h"

#include <cmath>
#include <utility>

#include "base/number_text.h"
#include "plot/contours.h"
#include "plot/map_colours.h"
#include "plot/map_layout.h"
#include "plot/map_legend.h"

namespace rotatebook::plot {
namespace {

constexpr Colour kDark{0.04, 0.045, 0.06};
constexpr Colour kWhite{0.97, 0.96, 0.93};

/// Draws one map.
class MapPlot {
 public:
  MapPlot(const study::MapResult& result, const scene::Scene& scene, const MapLayout& layout,
          overlay::Typesetter type)
      : result_(result),
        scene_(scene),
        map_(*scene.map),
        facts_(factsOf(result)),
        colouring_(map_.colours, facts_),
        layout_(layout),
        look_(layout.look),
        drawing_(layout.width, layout.height, layout.look.ground, std::move(type)) {}

  Drawing draw() {
    for (std::size_t panel = 0; panel < layout_.areas.size(); ++panel) {
      drawing_.picture(mapPixels(result_.values[panel], map_, colouring_, layout_.stride),
                       layout_.areas[panel].box);
      drawContours(panel);
      drawAxes(layout_.areas[panel], look_, {.hasYLabels = panel == 0}, drawing_);
      drawMarks(panel);
    }
    writeTexts();
    drawLegend(map_, facts_, colouring_, layout_, drawing_);
    return std::move(drawing_);
  }

 private:
  void drawContours(std::size_t panel) {
    const Box& box = layout_.areas[panel].box;
    const double each = 1.0 * layout_.scale / layout_.stride;
    for (const double level : map_.colours.contours) {
      std::vector<Point> pairs = contourOf(result_.values[panel], map_.width, map_.height, level);
      for (Point& point : pairs) {
        point = Point(box.x + (point.x() + 0.5) * each, box.bottom() - (point.y() + 0.5) * each);
      }
      drawing_.lines(pairs, {kWhite, 0.09 * look_.letters, 0.7});
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
    const double em = look_.letters, radius = 0.32 * em;
    TextStyle style = look_.bold;
    style.halo = 0.16 * em;
    std::vector<Box> taken;
    for (const study::MarkedValue& marked : result_.marks) {
      const Point at = layout_.areas[panel].placeOf(marked.mark.x, marked.mark.y);
      drawing_.disc(at, radius + 0.14 * em, kDark);
      drawing_.disc(at, radius, kWhite);
      drawing_.disc(at, 0.45 * radius, kDark);
      const std::string label = marked.mark.label + valueText(marked.values[panel]);
      const overlay::TextSize size = drawing_.sizeOf(label, style);
      const Box box{0, 0, 1.0 * size.width, 1.0 * size.height};
      taken.push_back(
          drawing_.write(label, style, placeOf(box, at, layout_.areas[panel].box, taken)));
    }
  }

  /// Returns a place beside the point for a label: the first of several that is within the area
  /// and free.
  Point placeOf(const Box& box, const Point& at, const Box& area,
                const std::vector<Box>& taken) const {
    const double gap = 0.75 * look_.letters;
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
      if (isFree(box.moved(place), area, taken)) return place;
    }
    return places.front();
  }

  void write(const std::string& text, const TextStyle& style, double x, double y,
             double anchor = 0) {
    drawing_.write(text, style, {x, y}, {anchor, 0}, layout_.textWidth);
  }

  void writeTexts() {
    const Area &first = layout_.areas.front(), &last = layout_.areas.back();
    const double left = first.box.x;
    write(scene_.title, look_.title, left, layout_.titleTop);
    write("↑ " + first.y.name, look_.name, left, layout_.axisNameTop);
    write(first.x.name + " →", look_.name, last.box.right(), layout_.xNameTop, 1);
    write(scene_.caption, look_.caption, left, layout_.captionTop);
    for (std::size_t panel = 0; panel < layout_.areas.size(); ++panel) {
      write(result_.labels[panel], look_.bold, layout_.areas[panel].box.x, layout_.panelNameTop);
    }
  }

  const study::MapResult& result_;
  const scene::Scene& scene_;
  const scene::MapSettings& map_;
  study::MapFacts facts_;
  MapColouring colouring_;
  const MapLayout& layout_;
  const Look& look_;
  Drawing drawing_;
};

}  // namespace

void requireMapLetters(const scene::Scene& scene) {
  std::vector<std::string> texts{scene.title, scene.caption, nameOf(scene.map->x),
                                 nameOf(scene.map->y)};
  for (const scene::MapMark& mark : scene.map->marks) texts.push_back(mark.label);
  for (const scene::Panel& panel : motionsOf(scene)) texts.push_back(panel.label);
  requireLetters(scene, texts);
}

Drawing drawMap(const study::MapResult& result, const scene::Scene& scene, int leastWidth) {
  overlay::Typesetter type = lettersOf(scene);
  const MapLayout layout(scene, type, leastWidth);
  return MapPlot(result, scene, layout, std::move(type)).draw();
}

image::Image mapPicture(const study::MapResult& result, const scene::Scene& scene, int leastWidth) {
  return drawMap(result, scene, leastWidth).pixels();
}

void writeMapPlot(const study::MapResult& result, const scene::Scene& scene,
                  const std::vector<std::filesystem::path>& files) {
  writePlot(drawMap(result, scene), files);
}

int mapWidth(const scene::Scene& scene) {
  return MapLayout(scene, lettersOf(scene), 0).width;
}

}  // namespace rotatebook::plot
