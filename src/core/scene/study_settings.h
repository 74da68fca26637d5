// [study]: what `rotatebook study` varies, and the results that it must find.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/motion_settings.h"
#include "scene/expectation.h"

namespace rotatebook::scene {

/// Bounds on one number; those that are present must hold.
struct Bounds {
  std::optional<double> min{};
  std::optional<double> max{};

  /// Returns whether `value` is within the bounds; NaN never is.
  bool hold(double value) const {
    return value == value && (!min || value >= *min) && (!max || value <= *max);
  }
  friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// Bounds on the order that an integrator must show.
struct ExpectedOrder {
  physics::Integrator integrator = physics::Integrator::Euler;
  Bounds bounds;

  friend bool operator==(const ExpectedOrder&, const ExpectedOrder&) = default;
};

/// A value that a sweep gives to a key.
struct SweepValue {
  std::string toml;                ///< As a scene states it, with its label if that is stated.
  std::string label;               ///< The number or the word, or what is stated.
  std::optional<double> number{};  ///< The value, if it is a number without a label.

  friend bool operator==(const SweepValue&, const SweepValue&) = default;
};

/// A key of a motion, "section.key", and the values that it gets.
struct SweepKey {
  std::string key;
  std::vector<SweepValue> values;  ///< At least one, each with another label.

  friend bool operator==(const SweepKey&, const SweepKey&) = default;
};

/// Bounds on a measured quantity of some of a sweep's runs.
struct SweepExpectation {
  Measure measure = Measure::HalfTurns;  ///< One of Sweep::measures.
  std::optional<std::string> at{};       ///< The label of a value; without it, all.
  std::optional<std::string> curve{};    ///< The label of a curve; without it, all.
  Bounds bounds{};

  friend bool operator==(const SweepExpectation&, const SweepExpectation&) = default;
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
  SweepKey over;
  std::optional<SweepKey> curves{};  ///< A second key: one curve for each of its values.
  std::vector<Measure> measures{};   ///< At least one, each once.
  std::vector<SweepExpectation> expected{};
  std::vector<SweepRun> runs{};  ///< Curve by curve, each in the order of the values.

  friend bool operator==(const Sweep&, const Sweep&) = default;
};

/// A study of integrators and steps, or of tilts, or of any key.
struct StudySettings {
  /// Integrators of the scene's model, each once; empty in other studies.
  std::vector<physics::Integrator> integrators{};
  /// Integration steps from one frame to the next, in place of SimulationSettings::substeps; each
  /// once, 1 to a million; empty in other studies.
  std::vector<int> steps{};
  std::vector<ExpectedOrder> orders{};  ///< For some of `integrators`.

  /// Angles in place of the one in [initial] tilt, each > 0 and at most half a right angle. [rad]
  std::vector<double> tilts{};
  /// Bounds on the greatest |measured interval / law - 1|.
  std::optional<Bounds> flipLaw{};

  std::optional<Sweep> sweep{};

  /// Length of the motions, > 0; without it, the clip's. [s]
  std::optional<double> duration{};
  /// Time between samples, which the steps divide, in place of SimulationSettings::timePerFrame; >
  /// 0. [s]
  std::optional<double> interval{};

  bool isOfTilts() const { return !tilts.empty(); }
  friend bool operator==(const StudySettings&, const StudySettings&) = default;
};

/// Returns all integrators of `model`, with 1, 2, 4 ... 1024 steps a frame; both empty for
/// Model::Exact.
StudySettings defaultStudy(physics::Model model);

}  // namespace rotatebook::scene
