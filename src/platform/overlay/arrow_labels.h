// Places letters at the tips of moving arrows. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "overlay/canvas.h"

namespace rotatebook::overlay {

/// An arrow as it is projected onto the picture.
struct ArrowShape {
  Point from{0, 0}, tip{0, 0};  ///< [pixels]
  /// Point where it comes out of the body, or from behind it; nothing if the body hides all of it.
  std::optional<Point> visibleFrom{};
  double lineWidth = 0;   ///< [pixels]
  double headLength = 0;  ///< [pixels]
  double headWidth = 0;   ///< At its base. [pixels]
};

/// Returns the length of the arrow's line and of its head's outline within `box`, except what the
/// body hides. [pixels]
double lengthWithin(const Box& box, const ArrowShape& arrow);

/// A side of an arrow, looking along it.
enum class Side { Left, Right };

/// The preferences by which a letter is placed.
struct LetterWish {
  Side side = Side::Right;  ///< The letter is moved to this side unless the other is much nearer.
  int rank = 0;             ///< Letters of low rank are placed first.
};

/// An arrow and the letter at its tip.
struct LabelledArrow {
  ArrowShape shape;
  const Layer* letter;  ///< Of the same size in all frames; must outlive the labels.
  double distance;      ///< From the tip to the letter's middle, if nothing is in its way. [pixels]
  LetterWish wish;
  bool inFront = true;  ///< Of the camera; otherwise neither arrow nor letter is drawn.
};

/// Returns the arrows of a frame of the motion: the same ones in the same order for all frames.
using ArrowsAt = std::function<std::vector<LabelledArrow>(std::int64_t frame)>;

/// Places letters at the tips of arrows: straight ahead if nothing is there. If another arrow or
/// letter is in the way, the letter moves around the tip and aside, as far as necessary.
///
/// Positions are averaged over the frames around the one that is drawn, with weights that fall off
/// linearly: letters glide from one side to the other when arrows pass each other, and stay where
/// they are when an arrow only sweeps by. A frame's letters thus depend on the motion, and not on
/// which frames were drawn before. No two letters ever overlap; a letter and another arrow may
/// while they pass.
class ArrowLabels {
 public:
  /// A letter that found its place.
  struct Placed {
    Box box;            ///< Without the halo, see boxOf().
    Box ink;            ///< Its visible pixels, halo included.
    std::size_t arrow;  ///< Index of its arrow.
  };

  ArrowLabels() = default;
  /// Takes the bounds of the picture, its areas that are `taken`, the index of the `last` frame,
  /// and how many frames before and after the drawn one are averaged, `reach` >= 0.
  ArrowLabels(const Box& picture, std::vector<Box> taken, std::int64_t last, std::int64_t reach);

  /// Places the letters of `frame`, none of them in `alsoTaken`; letters without room are left out.
  /// `arrowsAt` must be the same for each call until forget().
  void place(std::int64_t frame, const ArrowsAt& arrowsAt, const std::vector<Box>& alsoTaken = {});
  /// Writes the letters that were placed last.
  void write(Canvas& canvas) const;
  /// Clears the cached positions of other frames.
  void forget() { best_.clear(); }

  /// The arrows of the last frame whose letters were placed, and these.
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
