// CaptionAndClock of one motion: a panel's label, the count of half-turns, the end of a motion.
// Inside the room only.
#pragma once

#include <optional>

#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

/// CaptionAndClock at `place`, no wider than `width` [pixels], with halo. Throws InputError if the
/// font lacks a letter of them, or they leave too little of the picture.
CachedLayer labelLayer(const OverlayContext& context, const std::string& words, const Point& place,
                       double width);

/// "Half-turns 3", which lights up when the book turns over.
class HalfTurns final : public DrawnOverlay {
 public:
  /// Its top left is that of `place`.
  HalfTurns(const OverlayContext& context, const Box& place);
  void draw(const View& view) override;
  Box box() const override { return box_; }

 private:
  double glow(std::int64_t frame) const;

  OverlayContext context_;
  Box box_;
};

/// "Diverged at t = 22.53 s", on a dark pill in the middle above, below what is `taken` there;
/// none if a panel is too small for it.
std::optional<CachedLayer> divergenceNotice(const OverlayContext& context, double time,
                                            const std::vector<Box>& taken);

}  // namespace rotatebook::overlay
