// [study]: what `rotatebook study` varies, and the results that it must find.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/motion_settings.h"
#include "scene/axis.h"
#include "scene/expectation.h"

namespace rotatebook::scene {

/// Bounds on the order that an integrator must show.
struct ExpectedOrder {
  physics::Integrator integrator = physics::Integrator::Euler;
  Bounds bounds;

  friend bool operator==(const ExpectedOrder&, const ExpectedOrder&) = default;
};

/// A run of a sweep.
struct SweepRun {
  std::string value;  ///< The label of the value.
  std::string curve;  ///< The label of the curve; empty if there is no second key.
  physics::MotionSettings motion;

  friend bool operator==(const SweepRun&, const SweepRun&) = default;
};

/// Runs of the scene's motion with other values of one key, or of two.
struct Sweep {
  Axis x;
  std::optional<Axis> curves{};     ///< One curve for each of its values.
  std::vector<Measure> measures{};  ///< At least one, each once.
  /// Each of one of `measures`, without a window: on the runs with an x, on a curve, or all.
  std::vector<Expectation> expected{};
  std::vector<SweepRun> runs{};  ///< Curve by curve, each in the order of the values.

  friend bool operator==(const Sweep&, const Sweep&) = default;
};

/// A study of integrators and steps, or of tilts, or of any key.
struct StudySettings {
  /// Integrators of the scene's model, each once; empty in other studies.
  std::vector<physics::Integrator> integrators{};
  /// Numbers in place of SimulationSettings::substeps; each once, 1 to a million; empty in other
  /// studies.
  std::vector<int> steps{};
  std::vector<ExpectedOrder> orders{};  ///< For some of `integrators`.

  /// Angles in place of the one in [initial] tilt, each > 0 and at most half a right angle. [rad]
  std::vector<double> tilts{};
  /// Bounds on the greatest |measured interval / law - 1|.
  std::optional<Bounds> flipLaw{};

  std::optional<Sweep> sweep{};

  /// Length of the motions, > 0; without it, the clip's. [s]
  std::optional<double> duration{};
  /// Time between samples, whatever the steps, in place of SimulationSettings::timePerFrame; > 0.
  /// [s]
  std::optional<double> interval{};

  bool isOfTilts() const { return !tilts.empty(); }
  friend bool operator==(const StudySettings&, const StudySettings&) = default;
};

/// Returns all integrators of `model`, with 1, 2, 4 ... 1024 substeps; both empty for
/// Model::Exact.
StudySettings defaultStudy(physics::Model model);

}  // namespace rotatebook::scene
