// The time of simulators without steps. Inside the room only.
#pragma once

#include <cstdint>

namespace rotatebook::physics {

/// Adds intervals. A count of them keeps the time accurate to rounding after any number of equal
/// ones.
class SteplessClock {
 public:
  void advance(double interval) {
    if (interval != interval_) {
      start_ = time();
      interval_ = interval;
      count_ = 0;
    }
    ++count_;
  }
  void set(double time) {
    start_ = time;
    count_ = 0;
  }
  /// Returns the time since t = 0. [s]
  double time() const { return start_ + static_cast<double>(count_) * interval_; }

 private:
  double start_ = 0;
  double interval_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace rotatebook::physics
