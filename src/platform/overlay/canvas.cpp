#include "overlay/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include "image/zeroed_memory.h"
#include "overlay/cairo_handles.h"
#include "overlay/palette.h"

namespace rotatebook::overlay {
namespace {

constexpr double kLineHaloOpacity = 0.55;
// Points are clamped to this: Cairo clips only what its fixed-point coordinates can hold. [pixels]
constexpr double kFarAway = 20'000;

Point within(const Point& point) {
  return point.cwiseMax(-kFarAway).cwiseMin(kFarAway);
}

void setColour(cairo_t* cairo, const Colour& colour, double opacity) {
  cairo_set_source_rgba(cairo, colour.red, colour.green, colour.blue, opacity);
}

Box hullOf(std::span<const Point> points) {
  Point low = within(points.front()), high = low;
  for (const Point& point : points) {
    low = low.cwiseMin(within(point));
    high = high.cwiseMax(within(point));
  }
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

}  // namespace

struct Canvas::Parts {
  Parts(const image::Area& area, const Ink& colours)
      : place(area),
        width(area.width),
        height(area.height),
        ink(colours),
        pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4),
        surface(cairo_image_surface_create_for_data(pixels.data(), CAIRO_FORMAT_ARGB32, width,
                                                    height, width * 4)),
        cairo(cairo_create(surface.get())) {
    round();
  }

  explicit Parts(cairo_t* target) : cairo(cairo_reference(target)) { round(); }

  void round() const {
    cairo_set_line_cap(cairo.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo.get(), CAIRO_LINE_JOIN_ROUND);
  }

  /// Marks `box` as drawn in. The touched boxes never meet, so that nothing is blended twice.
  void touch(const Box& box) {
    if (!surface) return;
    const double left = std::clamp(std::floor(box.x) - 1, 0.0, 1.0 * width);
    const double top = std::clamp(std::floor(box.y) - 1, 0.0, 1.0 * height);
    const double right = std::clamp(std::ceil(box.right()) + 1, 0.0, 1.0 * width);
    const double bottom = std::clamp(std::ceil(box.bottom()) + 1, 0.0, 1.0 * height);
    Box whole{left, top, right - left, bottom - top};
    if (whole.empty()) return;
    for (std::size_t i = 0; i < touched.size();) {
      if (!touched[i].meets(whole)) {
        ++i;
        continue;
      }
      whole = whole.united(touched[i]);
      touched.erase(touched.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
    touched.push_back(whole);
  }

  LayerView view(const Box& box) const {
    const auto x = static_cast<int>(box.x), y = static_cast<int>(box.y);
    return {x,
            y,
            static_cast<int>(box.width),
            static_cast<int>(box.height),
            pixels.data() + (static_cast<std::ptrdiff_t>(y) * width + x) * 4,
            static_cast<std::ptrdiff_t>(width) * 4};
  }

  void clear() {
    cairo_surface_flush(surface.get());
    for (const Box& box : touched) {
      const LayerView part = view(box);
      for (int y = 0; y < part.height; ++y) {
        std::uint8_t* row =
            pixels.data() + (static_cast<std::ptrdiff_t>(part.y + y) * width + part.x) * 4;
        std::memset(row, 0, static_cast<std::size_t>(part.width) * 4);
      }
    }
    touched.clear();
    cairo_surface_mark_dirty(surface.get());
  }

  /// Strokes the current path, which lies within `hull`.
  void stroke(const Box& hull, const Pen& pen) {
    touch(hull.grown(pen.width / 2 + pen.halo));
    if (pen.halo > 0) {
      setColour(cairo.get(), ink(kDark), kLineHaloOpacity * pen.opacity);
      cairo_set_line_width(cairo.get(), pen.width + 2 * pen.halo);
      cairo_stroke_preserve(cairo.get());
    }
    setColour(cairo.get(), ink(pen.colour), pen.opacity);
    cairo_set_line_width(cairo.get(), pen.width);
    cairo_stroke(cairo.get());
  }

  void polygon(std::span<const Point> corners) const {
    cairo_new_sub_path(cairo.get());
    for (const Point& corner : corners)
      cairo_line_to(cairo.get(), within(corner).x(), within(corner).y());
    cairo_close_path(cairo.get());
  }

  void fill(const Box& hull, const Fill& fill) {
    touch(hull);
    setColour(cairo.get(), ink(fill.colour), fill.opacity);
    cairo_fill(cairo.get());
  }

  /// Returns where a layer is in a picture.
  LayerView placed(LayerView layer) const {
    layer.x += place.x;
    layer.y += place.y;
    return layer;
  }

  void note(const std::vector<Box>& more) { texts.insert(texts.end(), more.begin(), more.end()); }

  image::Area place;  // In the picture.
  int width = 0, height = 0;
  Ink ink;
  image::ZeroedBytes pixels;
  Surface surface;
  Cairo cairo;
  std::vector<Box> touched;
  std::vector<Box> texts;
};

Canvas::Canvas(int width, int height, const Ink& ink)
    : Canvas(image::Area{0, 0, width, height}, ink) {}
Canvas::Canvas(const image::Area& panel, const Ink& ink)
    : parts_(std::make_unique<Parts>(panel, ink)) {}
Canvas::Canvas(_cairo* target) : parts_(std::make_unique<Parts>(target)) {}
Canvas::~Canvas() = default;

void Canvas::line(std::span<const Point> points, const Pen& pen) {
  if (points.size() < 2) return;
  for (const Point& point : points) {
    cairo_line_to(parts_->cairo.get(), within(point).x(), within(point).y());
  }
  parts_->stroke(hullOf(points), pen);
}

void Canvas::lines(std::span<const Point> pairs, const Pen& pen) {
  if (pairs.size() < 2) return;
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    cairo_move_to(parts_->cairo.get(), within(pairs[i]).x(), within(pairs[i]).y());
    cairo_line_to(parts_->cairo.get(), within(pairs[i + 1]).x(), within(pairs[i + 1]).y());
  }
  parts_->stroke(hullOf(pairs), pen);
}

void Canvas::area(std::span<const Point> corners, const Fill& fill) {
  if (corners.size() < 3) return;
  parts_->polygon(corners);
  parts_->fill(hullOf(corners), fill);
}

void Canvas::areaWithout(std::span<const std::vector<Point>> holes, std::span<const Point> corners,
                         const Fill& fill) {
  if (corners.size() < 3) return;
  cairo_t* cairo = parts_->cairo.get();
  cairo_save(cairo);
  parts_->polygon(corners);
  cairo_clip(cairo);
  const Box hull = hullOf(corners);
  cairo_rectangle(cairo, hull.x, hull.y, hull.width, hull.height);
  for (const std::vector<Point>& hole : holes) parts_->polygon(hole);
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
  parts_->fill(hull, fill);
  cairo_restore(cairo);
}

void Canvas::disc(const Point& centre, double radius, const Fill& fill) {
  if (within(centre) != centre) return;
  cairo_arc(parts_->cairo.get(), centre.x(), centre.y(), radius, 0, 2 * std::numbers::pi);
  parts_->fill(Box{centre.x(), centre.y(), 0, 0}.grown(radius), fill);
}

void Canvas::roundedBox(const Box& box, double radius, const Fill& fill) {
  constexpr double kRight = std::numbers::pi / 2;
  cairo_t* cairo = parts_->cairo.get();
  cairo_arc(cairo, box.right() - radius, box.y + radius, radius, -kRight, 0);
  cairo_arc(cairo, box.right() - radius, box.bottom() - radius, radius, 0, kRight);
  cairo_arc(cairo, box.x + radius, box.bottom() - radius, radius, kRight, 2 * kRight);
  cairo_arc(cairo, box.x + radius, box.y + radius, radius, 2 * kRight, 3 * kRight);
  parts_->fill(box, fill);
}

void Canvas::write(const Layer& text, const Point& position) {
  paint(text, position);
  parts_->texts.push_back(boxOf(text, position));
}

void Canvas::paint(const Layer& layer, const Point& position) {
  const Surface source(cairo_image_surface_create_for_data(
      // Cairo only reads from it.
      const_cast<unsigned char*>(layer.pixels.data()), CAIRO_FORMAT_ARGB32, layer.width,
      layer.height, layer.width * 4));
  const double x = position.x() + layer.x, y = position.y() + layer.y;
  cairo_set_source_surface(parts_->cairo.get(), source.get(), x, y);
  cairo_paint(parts_->cairo.get());
  parts_->touch({x, y, 1.0 * layer.width, 1.0 * layer.height});
  setColour(parts_->cairo.get(), kWhite, 1);  // releases `source`
}

void Canvas::layOver(image::Image& picture) {
  cairo_surface_flush(parts_->surface.get());
  for (const Box& box : parts_->touched)
    blendWithin(parts_->place, parts_->placed(parts_->view(box)), picture);
  parts_->clear();
}

void Canvas::lay(const LayerView& layer, image::Image& picture) {
  if (!parts_->touched.empty()) layOver(picture);
  blendWithin(parts_->place, parts_->placed(layer), picture);
}

void Canvas::lay(const CachedLayer& cached, image::Image& picture) {
  lay(viewOf(cached.layer), picture);
  parts_->note(cached.texts);
}

void Canvas::layStill(const CachedLayer& cached, image::Image& picture) {
  blendOverTouched(parts_->place, parts_->placed(viewOf(cached.layer)), picture);
  parts_->note(cached.texts);
}

CachedLayer Canvas::take() {
  cairo_surface_flush(parts_->surface.get());
  Box all;
  for (const Box& box : parts_->touched) all = all.united(box);
  const LayerView part = parts_->view(all);
  CachedLayer cached{{part.x, part.y, part.width, part.height, {}},
                     std::exchange(parts_->texts, {})};
  const auto rowSize = static_cast<std::ptrdiff_t>(part.width) * 4;
  for (int y = 0; y < part.height; ++y) {
    const std::uint8_t* row = part.pixels + y * part.stride;
    cached.layer.pixels.insert(cached.layer.pixels.end(), row, row + rowSize);
  }
  parts_->clear();
  return cached;
}

const std::vector<Box>& Canvas::texts() const {
  return parts_->texts;
}

void Canvas::forgetTexts() {
  parts_->texts.clear();
}

Box boxOf(const Layer& text, const Point& position) {
  return {position.x(), position.y(), 1.0 * (text.width + 2 * text.x),
          1.0 * (text.height + 2 * text.y)};
}

}  // namespace rotatebook::overlay
