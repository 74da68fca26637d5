// The springs between the particles. Inside the room only.
#pragma once

#include <vector>

#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

/// The 28 springs, coloured by how far they are stretched or compressed, the particles, and a
/// legend. Of Model::Particles only.
class Springs final : public DrawnOverlay {
 public:
  /// The legend is within `legend`.
  Springs(const OverlayContext& context, const Box& legend);
  void draw(const View& view) override;

 private:
  OverlayContext context_;
  double range_;  // the strain that has the full colour
  CachedLayer legend_;
};

/// A number of one digit, 1, 2 or 5 with a power of ten, that is at least `value` > 0.
double roundedUp(double value);

}  // namespace rotatebook::overlay
