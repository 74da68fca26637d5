// Lines, areas and words on their way onto a picture. Inside the room only.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "image/image.h"
#include "overlay/box.h"
#include "overlay/layer.h"
#include "overlay/text.h"

namespace rotatebook::overlay {

/// How a line looks.
struct Pen {
  Colour colour;
  double width = 1;  ///< [pixels]
  double opacity = 1;
  double halo = 0;  ///< How far a dark edge reaches on both sides. [pixels]
};

/// How an area looks.
struct Fill {
  Colour colour;
  double opacity = 1;
};

/// A transparent sheet as large as the picture. What is drawn on it is laid over the picture at
/// once, and only where something was drawn. Use it on one thread.
class Canvas {
 public:
  /// > 0 [pixels]
  Canvas(int width, int height);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  /// A line through two points or more, round at its ends and corners. Points that are far outside
  /// the picture are fine.
  void line(std::span<const Point> points, const Pen& pen);
  /// Separate lines, each from one point to the next, in one go: they cover each other's halos.
  void lines(std::span<const Point> pairs, const Pen& pen);
  /// The area within a polygon.
  void area(std::span<const Point> corners, const Fill& fill);
  void disc(const Point& centre, double radius, const Fill& fill);
  /// A rectangle whose corners are round.
  void roundedBox(const Box& box, double radius, const Fill& fill);
  /// `words`, with their top left, without halo, at `place`; fractions of a pixel count.
  void write(const Layer& words, const Point& place);
  /// A piece of picture, which has no words; else the same.
  void paint(const Layer& piece, const Point& place);

  /// Lays what was drawn over `picture`, which is of this size, and starts afresh.
  void layOver(image::Image& picture);
  /// Lays `cached` over `picture`, above all that was drawn before.
  void lay(const CachedLayer& cached, image::Image& picture);
  /// What was drawn, words included, as a piece of its own; starts afresh.
  CachedLayer take();

  /// Where words were written or laid since forgetTexts().
  const std::vector<Box>& texts() const;
  void forgetTexts();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The box of `words` as write() puts them, without halo.
Box boxOf(const Layer& words, const Point& place);

}  // namespace rotatebook::overlay
