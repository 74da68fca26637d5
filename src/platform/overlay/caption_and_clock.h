// What is written over the pictures of a clip.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "image/image.h"
#include "overlay/box.h"
#include "scene/scene.h"

namespace rotatebook::overlay {

/// Writes over the pictures of one clip the caption and the clock, if its scene shows them; what
/// doesn't change is drawn once. Use it on one thread. Letters are a share of the picture's height,
/// but never too small to read.
class CaptionAndClock {
 public:
  /// Where the clock is.
  enum class ClockPosition {
    TopLeft,
    Bottom,  ///< On the right of the caption's first line, for pictures whose top has other words.
  };

  /// Throws InputError, with the place in the scene, if there is no such font, if it lacks a letter
  /// of the words, or if they would take more than half of a picture of 360 rows or more.
  explicit CaptionAndClock(const scene::Scene& scene, ClockPosition place = ClockPosition::TopLeft);
  ~CaptionAndClock();
  CaptionAndClock(CaptionAndClock&&) noexcept;
  CaptionAndClock& operator=(CaptionAndClock&&) noexcept;

  /// Rows at the picture's bottom that words take, 0 to half of them. [pixels]
  int bottomRows() const;
  /// What the clock takes of the picture's top left; empty if it isn't there.
  Box corner() const;
  /// Draws over `picture`, of the clip's size, which shows frame `frame`.
  void draw(std::int64_t frame, image::Image& picture);

  /// Where the last draw() has put words, each a box of its own. [pixels]
  const std::vector<Box>& texts() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::overlay
