// Draws the springs between the particles. Inside the room only.
#pragma once

#include "overlay/drawn_overlay.h"

namespace rotatebook::overlay {

/// The 28 springs, coloured by strain, the particles, and a legend. For Model::Particles only.
class Springs final : public DrawnOverlay {
 public:
  /// Takes the box of the legend.
  Springs(const OverlayContext& context, const Box& legend);
  void draw(const View& view) override;

 private:
  OverlayContext context_;
  double range_;  // strain of full colour
  CachedLayer legend_;
};

/// Rounds `value` > 0 up to 1, 2 or 5 times a power of ten.
double roundedUp(double value);

}  // namespace rotatebook::overlay
