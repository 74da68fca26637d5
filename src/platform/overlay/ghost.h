// Draws the exact motion beside the simulated one. Inside the room only.
#pragma once

#include "overlay/drawn_overlay.h"
#include "physics/exact/exact_rotation.h"

namespace rotatebook::overlay {

/// The body in the exact motion from the same start, as a translucent outline.
class Ghost final : public DrawnOverlay {
 public:
  explicit Ghost(const OverlayContext& context);
  void draw(const View& view) override;

 private:
  OverlayContext context_;
  physics::ExactRotation exact_;
};

}  // namespace rotatebook::overlay
