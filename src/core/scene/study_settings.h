// [study]: what `rotatebook study` varies, and the results that it must find.
#pragma once

#include <optional>
#include <vector>

#include "physics/motion_settings.h"

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

/// Either a study of integrators and steps, or one of tilts.
struct StudySettings {
  /// Integrators of the scene's model, each once; empty in a study of tilts.
  std::vector<physics::Integrator> integrators{};
  /// Integration steps from one frame to the next, in place of SimulationSettings::substeps; each
  /// once, 1 to a million; empty in a study of tilts.
  std::vector<int> steps{};
  std::vector<ExpectedOrder> orders{};  ///< For some of `integrators`.

  /// Angles in place of the one in [initial] tilt, each > 0 and at most half a right angle. [rad]
  std::vector<double> tilts{};
  /// Bounds on the greatest |measured interval / law - 1|.
  std::optional<Bounds> flipLaw{};

  bool isOfTilts() const { return !tilts.empty(); }
  friend bool operator==(const StudySettings&, const StudySettings&) = default;
};

/// Returns all integrators of `model`, with 1, 2, 4 ... 1024 steps a frame; both empty for
/// Model::Exact.
StudySettings defaultStudy(physics::Model model);

}  // namespace rotatebook::scene
