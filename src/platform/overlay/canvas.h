// Draws lines, areas and text to be laid over a picture.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "image/area.h"
#include "image/image.h"
#include "overlay/box.h"
#include "overlay/ink.h"
#include "overlay/layer.h"
#include "overlay/text.h"

namespace rotatebook::overlay {

/// The look of a line.
struct Pen {
  Colour colour;
  double width = 1;  ///< [pixels]
  double opacity = 1;
  double halo = 0;  ///< Width of a dark edge on both sides. [pixels]
};

/// The look of an area.
struct Fill {
  Colour colour;
  double opacity = 1;
};

/// A transparent sheet of the size of a picture, or of a panel in one. It is laid over that at
/// once, and only where something was drawn. Use it on one thread.
class Canvas {
 public:
  /// Takes the picture's width and height, > 0 [pixels], and what turns the colours of lines and
  /// areas into those that are drawn.
  Canvas(int width, int height, const Ink& ink = {});
  /// Takes the place of a panel in the picture. [pixels]
  Canvas(const image::Area& panel, const Ink& ink);
  /// Draws with Cairo at once rather than on a sheet of its own: nothing is left to be laid.
  explicit Canvas(_cairo* target);
  ~Canvas();

  /// Strokes a line through two points or more, with round caps and joins. Points far outside the
  /// picture are fine.
  void line(std::span<const Point> points, const Pen& pen);
  /// Strokes separate lines, each from one point to the next, as one path: the lines cover each
  /// other's halos.
  void lines(std::span<const Point> pairs, const Pen& pen);
  /// Fills a polygon.
  void area(std::span<const Point> corners, const Fill& fill);
  /// Fills a polygon but for its parts within `holes`, polygons that don't overlap.
  void areaWithout(std::span<const std::vector<Point>> holes, std::span<const Point> corners,
                   const Fill& fill);
  void disc(const Point& centre, double radius, const Fill& fill);
  /// Fills a rectangle with round corners.
  void roundedBox(const Box& box, double radius, const Fill& fill);
  /// Draws `text` with its top left, the halo not counted, at `position`, which may be between
  /// pixels; notes its box in texts().
  void write(const Layer& text, const Point& position);
  /// Like write(), for an image without text.
  void paint(const Layer& layer, const Point& position);

  /// Lays the drawing over its place in `picture`, and clears the canvas.
  void layOver(image::Image& picture);
  /// Lays the drawing, and a layer above it, over its place in `picture`.
  void lay(const LayerView& layer, image::Image& picture);
  void lay(const CachedLayer& cached, image::Image& picture);
  /// Lays a layer alone, over those tiles that were touched since Image::beginOn().
  void layStill(const CachedLayer& cached, image::Image& picture);
  /// Returns the drawing and its texts() as a layer, and clears the canvas.
  CachedLayer take();

  /// Returns the boxes of all text that was written or laid since forgetTexts().
  const std::vector<Box>& texts() const;
  void forgetTexts();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Returns the box of `text` without its halo when write() puts it at `position`.
Box boxOf(const Layer& text, const Point& position = Point(0, 0));

}  // namespace rotatebook::overlay
