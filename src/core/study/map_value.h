// The values of a map's runs. Inside the room only.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "physics/measure/exact_tilt.h"
#include "physics/motion_settings.h"
#include "physics/simulate.h"
#include "scene/map_settings.h"
#include "study/execution.h"
#include "study/lanes/ensemble.h"

namespace rotatebook::study {

/// The settings that all runs of a map have in common.
struct MapPlan {
  scene::Measure measure;
  scene::MapMoment moment;
  double duration;  // [s]

  bool is(scene::Measure other) const { return measure == other; }
};

/// A motion that is looked at from interval to interval.
struct MapRun {
  physics::MotionSettings motion{};
  double interval = 0;  // [s]
};

/// The value of a motion from moment to moment, without what it doesn't depend on.
class ValueOverTime {
 public:
  /// Takes a measure that isn't of the way. Throws as physics::Simulation does.
  ValueOverTime(const physics::MotionSettings& motion, scene::Measure measure);

  /// Returns the value at `time`, not before those so far [s], or kDiverged. Throws StepError.
  double at(double time);

 private:
  scene::Measure measure_;
  std::optional<physics::ExactTilt> tilt_{};         // that of an exact motion, or
  std::optional<physics::Simulation> simulation_{};  // samples
};

/// The values of runs that are handed in one by one, and are made several at a time.
class MapValues {
 public:
  /// After a stop the values mean nothing.
  MapValues(const MapPlan& plan, Stop stop);

  /// Takes the next run. Returns its number, from 0.
  std::size_t add(const MapRun& run);
  /// Returns the values of all runs, in their order, or kNever, kDiverged or kRefused.
  std::vector<double> finish();

 private:
  MapPlan plan_;
  Stop stop_;
  lanes::Ensemble ensemble_;
  lanes::WatchedMotion watched_{};
  std::vector<double> values_{};
  std::size_t count_ = 0;
};

}  // namespace rotatebook::study
