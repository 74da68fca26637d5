// Colours of overlays on dark and on bright ground. Inside the room only.
#pragma once

#include <optional>

#include "overlay/colour.h"
#include "scene/scene.h"

namespace rotatebook::overlay {

/// Turns the overlays' colours, which are for dark ground, into those for a clip's background.
class Ink {
 public:
  /// Dark ground.
  Ink() = default;
  /// The ground that `scene` has: bright if black has more contrast on it than white.
  explicit Ink(const scene::Scene& scene);

  /// Returns `colour` itself on dark ground. On bright ground dark colours become light, and light
  /// ones dark, in the same hue, with a contrast of 4.5 or as close as their hue comes.
  Colour operator()(const Colour& colour) const;

 private:
  std::optional<double> luminance_;  // of bright ground
};

}  // namespace rotatebook::overlay
