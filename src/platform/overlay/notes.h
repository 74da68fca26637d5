// Words of one motion: a panel's label, the count of half-turns, the end of a motion. Inside the
// room only.
#pragma once

#include <optional>

#include "overlay/mark.h"

namespace rotatebook::overlay {

/// Words at `place`, no wider than `width` [pixels], with halo. Throws InputError if the font lacks
/// a letter of them, or they leave too little of the picture.
Plate labelPlate(const MarkContext& context, const std::string& words, const Point& place,
                 double width);

/// "Half-turns 3", which lights up when the book turns over.
class HalfTurns final : public Mark {
 public:
  /// Its top left is that of `place`.
  HalfTurns(const MarkContext& context, const Box& place);
  void draw(const View& view) override;
  Box box() const override { return box_; }

 private:
  double glow(std::int64_t frame) const;

  MarkContext context_;
  Box box_;
};

/// "Diverged at t = 22.53 s", on a dark pill in the middle above, below what is `taken` there;
/// none if a panel is too small for it.
std::optional<Plate> divergenceNotice(const MarkContext& context, double time,
                                      const std::vector<Box>& taken);

}  // namespace rotatebook::overlay
