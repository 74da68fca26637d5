// The springs between the particles. Inside the room only.
#pragma once

#include <vector>

#include "overlay/mark.h"

namespace rotatebook::overlay {

/// The 28 springs, coloured by how far they are stretched or compressed, the particles, and a
/// legend. Of Model::Particles only.
class Springs final : public Mark {
 public:
  /// The legend is within `legend`.
  Springs(const MarkContext& context, const Box& legend);
  void draw(const View& view) override;

 private:
  MarkContext context_;
  double range_;  // the strain that has the full colour
  Plate legend_;
};

/// A number of one digit, 1, 2 or 5 with a power of ten, that is at least `value` > 0.
double roundedUp(double value);

}  // namespace rotatebook::overlay
