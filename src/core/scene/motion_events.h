// The times of a motion's events. Inside the room only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physics/simulate.h"
#include "scene/moment.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// The events of one motion, which is simulated as far as they are.
class MotionEvents {
 public:
  /// Takes samples at multiples of `interval` up to `longest`. [s]
  MotionEvents(const Panel& motion, double interval, double longest);

  /// Returns the time of a flip, a nudge or a burst. [s] Throws InputError if there is none.
  double timeOf(const Moment& moment);

 private:
  bool advance();
  double foundFiner(double after, double until) const;
  std::string lastingText() const;
  double flip(const Moment& moment);
  double nudge(const Moment& moment) const;
  double burst();

  const Panel& motion_;
  double interval_, longest_;  // [s]
  std::optional<physics::Simulation> simulation_;
  std::int64_t samples_ = 1;
  physics::Sample last_;
  std::vector<double> flips_;    // [s]
  std::optional<double> burst_;  // [s]
  bool isDone_ = false;
};

}  // namespace rotatebook::scene
