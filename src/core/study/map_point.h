// The motion that belongs to a point of a map. Inside the room only.
#pragma once

#include <optional>

#include "physics/motion_settings.h"
#include "scene/map_settings.h"
#include "scene/motion_numbers.h"

namespace rotatebook::study {

/// Gives the motions of one panel the values of the two axes.
class MapPoints {
 public:
  MapPoints(const physics::MotionSettings& base, const scene::MapSettings& map);

  /// Returns the motion at a point. Throws InputError if there is none.
  physics::MotionSettings at(double x, double y) const;

 private:
  struct Axis {
    scene::AxisKind kind = scene::AxisKind::MotionKey;
    std::optional<scene::MotionNumber> number{};
  };

  static Axis axisOf(const scene::Axis& axis, const physics::MotionSettings& base);

  physics::MotionSettings base_;
  Axis x_, y_;
};

}  // namespace rotatebook::study
