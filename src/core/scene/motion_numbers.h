// Numbers of a motion, named by their keys.
#pragma once

#include <functional>
#include <string>

#include "physics/motion_settings.h"

namespace rotatebook::scene {

/// Follows a key of a nudge in the message where there is none.
inline constexpr const char* kOfNoNudge =
    " is a part of a [[nudge]], and the scene states none; state it";

/// A number of a motion that can be given other values.
class MotionNumber {
 public:
  /// Takes a key such as "simulation.substeps", or a number within one that `base` has a value of,
  /// such as "initial.tilt.0". Throws InputError "LOCATION: PROBLEM" if there is no such key, or it
  /// doesn't take `example`.
  MotionNumber(const physics::MotionSettings& base, const std::string& key, double example,
               const std::string& location);

  /// Gives it another value, rounded if it must be whole. Throws InputError likewise if the value
  /// isn't allowed.
  void set(physics::MotionSettings& motion, double value) const { set_(motion, value); }
  bool isWhole() const { return isWhole_; }

 private:
  std::function<void(physics::MotionSettings&, double)> set_;
  bool isWhole_ = false;
};

}  // namespace rotatebook::scene
