// Letters at the tips of arrows that move. Inside the room only.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "overlay/canvas.h"

namespace rotatebook::overlay {

/// An arrow as it lies on the picture.
struct ArrowShape {
  Point from{0, 0}, tip{0, 0};  ///< [pixels]
  /// Where it comes out of the body, or from behind it; nothing if the body hides all of it.
  std::optional<Point> visibleFrom{};
  double lineWidth = 0;   ///< [pixels]
  double headLength = 0;  ///< [pixels]
  double headWidth = 0;   ///< Where it is widest. [pixels]
};

/// How many pixels of the arrow's line and of its head's outline, as far as the body doesn't hide
/// them, lie within `box`.
double lengthWithin(const Box& box, const ArrowShape& arrow);

/// A side of an arrow, as one sees it who looks along the arrow.
enum class Side { Left, Right };

/// Where a letter is to go.
struct LetterWish {
  Side side = Side::Right;  ///< To which it gives way, unless the other is much nearer.
  int rank = 0;             ///< Letters of the lowest choose first.
};

/// An arrow and the letter at its tip.
struct LabelledArrow {
  ArrowShape shape;
  const Layer* letter;  ///< Its size is the same in all frames; must outlive the labels.
  double distance;      ///< From the tip to the letter's middle, if nothing is in its way. [pixels]
  LetterWish wish;
  bool inFront = true;  ///< Of the camera; an arrow that isn't is not drawn and has no letter.
};

/// The arrows of a frame of the motion, the same ones in the same order for all frames.
using ArrowsAt = std::function<std::vector<LabelledArrow>(std::int64_t frame)>;

/// Puts letters at the tips of arrows: straight ahead if nothing is there. Where another arrow or
/// letter is in its way, a letter goes round the tip and aside, as far as it takes.
///
/// Of the frames around the one that is drawn the mean is taken, weighted less the farther they
/// are, so that letters glide from one side to the other where arrows pass each other, and keep
/// their places where one sweeps by. So a frame's letters depend on the motion, and not on which
/// frames were drawn before. No two letters meet, ever; a letter and another arrow do while one
/// passes.
class ArrowLabels {
 public:
  /// A letter as it was written; its box as boxOf() has it.
  struct Placed {
    Box box;
    Box ink;            ///< What is drawn of it, halo included.
    std::size_t arrow;  ///< Its index.
  };

  ArrowLabels() = default;
  /// For frames 0 to `last`, of which `reach` >= 0 before and after the one that is drawn count, on
  /// a picture with areas `taken`.
  ArrowLabels(const Box& picture, std::vector<Box> taken, std::int64_t last, std::int64_t reach);

  /// Writes the letters of `frame`, none of them in `alsoTaken`; those that find no place are left
  /// out. `arrowsAt` is the same for each call until forget().
  void write(Canvas& canvas, std::int64_t frame, const ArrowsAt& arrowsAt,
             const std::vector<Box>& alsoTaken = {});
  /// Forgets what is known of other frames.
  void forget() { best_.clear(); }

  /// The arrows of the last frame that was written, and its letters.
  const std::vector<LabelledArrow>& arrows() const { return arrows_; }
  const std::vector<Placed>& placed() const { return placed_; }

 private:
  const std::vector<Point>& bestAt(std::int64_t frame, const ArrowsAt& arrowsAt);
  std::vector<Point> meanAround(std::int64_t frame, const ArrowsAt& arrowsAt);

  Box picture_;
  std::vector<Box> taken_;
  std::int64_t last_ = 0, reach_ = 0;
  std::map<std::int64_t, std::vector<Point>> best_;  // of frames near the last one
  std::vector<LabelledArrow> arrows_;
  std::vector<Placed> placed_;
};

}  // namespace rotatebook::overlay
