// Simulators without steps. Inside the room only.
#pragma once

#include <cstdint>

#include "physics/simulator.h"

namespace rotatebook::physics {

/// A simulator whose motion is known at any time. It adds intervals: a count of them keeps the time
/// accurate to rounding after any number of equal ones.
class SteplessSimulator : public Simulator {
 public:
  void advance(double interval, int /*steps*/) final { advancePart(interval); }
  void advancePart(double part) final {
    if (part != interval_) {
      start_ = time();
      interval_ = part;
      count_ = 0;
    }
    ++count_;
  }
  bool jumpTo(double time) final {
    start_ = time;
    count_ = 0;
    return true;
  }
  /// Does nothing: the motion knows all nudges and their times.
  void nudge(const Nudge& /*nudge*/) final {}

 protected:
  /// Returns the time since t = 0. [s]
  double time() const { return start_ + static_cast<double>(count_) * interval_; }

 private:
  double start_ = 0;
  double interval_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace rotatebook::physics
