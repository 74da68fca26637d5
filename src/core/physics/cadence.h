// Counts steps. Inside the room only.
#pragma once

namespace rotatebook::physics {

/// Counts steps, and says after which of them a correction is due.
class Cadence {
 public:
  /// Makes a correction due after every `every`th step; never if 0.
  explicit Cadence(int every) : every_(every), left_(every) {}

  /// Counts a step. Returns whether a correction is due after it.
  bool isDue() {
    if (every_ == 0 || --left_ > 0) return false;
    left_ = every_;
    return true;
  }

 private:
  int every_;
  int left_;  // steps until the next correction
};

}  // namespace rotatebook::physics
