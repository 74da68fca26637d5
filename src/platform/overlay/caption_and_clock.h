// Draws the caption and the clock over the pictures of a clip.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "image/image.h"
#include "overlay/box.h"
#include "scene/scene.h"

namespace rotatebook::overlay {

/// Draws the caption and the clock over the pictures of one clip, if its scene shows them. All
/// captions of a clip have the room of the tallest one. Use it on one thread. Letters are a share
/// of the picture's height, but never too small to read. In a picture of fewer than 360 rows,
/// settings, caption and title are left out, in this order, as far as they would take more than
/// half of it.
class CaptionAndClock {
 public:
  enum class ClockPosition {
    TopLeft,
    Bottom,  ///< Beside the caption's first line, for pictures that have other text at the top.
  };

  /// Throws InputError, with the line of the scene, if its font isn't installed or lacks a letter,
  /// or if the text would take more than half of a picture of 360 rows or more.
  explicit CaptionAndClock(const scene::Scene& scene,
                           ClockPosition position = ClockPosition::TopLeft);
  ~CaptionAndClock();

  /// Returns how many rows at the picture's bottom the text takes, 0 to half of them. [pixels]
  int bottomRows() const;
  /// Returns the box of the clock at the top left; empty if it isn't there. [pixels]
  Box corner() const;
  /// Returns the cues, by their index, whose texts take more than two lines.
  const std::vector<std::size_t>& longCues() const;
  /// Draws over `picture`, of the clip's size, which shows frame `frame`.
  void draw(std::int64_t frame, image::Image& picture) { draw(frame, frame, picture); }
  /// Draws likewise, with the clock of `clockFrame`.
  void draw(std::int64_t frame, std::int64_t clockFrame, image::Image& picture);

  // The steps of draw().
  /// Sets the caption to that of `frame`; returns whether it was another one, or none.
  bool setCaption(std::int64_t frame);
  /// Draws all but the clock over the tiles of `picture` that were touched since Image::beginOn().
  void drawCaption(image::Image& picture);
  void drawClock(std::int64_t clockFrame, image::Image& picture);

  /// Returns a box for each text that was drawn since setCaption(). [pixels]
  const std::vector<Box>& texts() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rotatebook::overlay
