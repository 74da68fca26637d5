// [study]: what `rotatebook study` varies, and the results that it must find.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/axis.h"
#include "scene/expectation.h"

namespace rotatebook::scene {

/// Runs of the scene's motion with other values of one key, or of two.
struct StudySettings {
  Axis x;
  std::optional<Axis> curves{};     ///< One curve for each of its values.
  std::vector<Measure> measures{};  ///< At least one, each once.
  /// Each of one of `measures`, without a window: on the runs with an x, on a curve, or all.
  std::vector<Expectation> expected{};
  /// Length of the motions, > 0; without it, the clip's. [s]
  std::optional<double> duration{};
  /// Time between samples, whatever the steps, in place of SimulationSettings::timePerFrame; > 0.
  /// [s]
  std::optional<double> interval{};

  bool varies(std::string_view key) const { return x.key == key || (curves && curves->key == key); }
  friend bool operator==(const StudySettings&, const StudySettings&) = default;
};

}  // namespace rotatebook::scene
