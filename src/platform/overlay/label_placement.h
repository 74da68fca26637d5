// Short words at things that move. Inside the room only.
#pragma once

#include <span>
#include <vector>

#include "overlay/canvas.h"

namespace rotatebook::overlay {

/// Puts words next to points so that none meets another or an area that is taken. CaptionAndClock
/// that find no place are left out.
class LabelPlacement {
 public:
  /// `words` beside `tip`, best in `direction` from it, at `distance` from the words' middle.
  /// [pixels] Those that come first choose first. `words` must outlive write().
  void add(const Layer& words, const Point& tip, const Point& direction, double distance);
  /// Writes all within the picture, and starts afresh.
  void write(Canvas& canvas, const Box& picture, std::vector<Box> taken);

 private:
  struct Label {
    const Layer* words;
    Point tip, direction;
    double distance;
  };
  std::vector<Label> labels_;
};

}  // namespace rotatebook::overlay
