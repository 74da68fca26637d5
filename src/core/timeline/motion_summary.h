// A motion in a few numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "timeline/clip_motion.h"

namespace rotatebook::timeline {

/// Largest angle between two attitudes that a viewer doesn't notice. [degrees]
inline constexpr double kVisibleErrorDeg = 10;

/// A motion's results. Energies are relative to the start.
struct MotionSummary {
  scene::Panel motion;          ///< The settings; without a label if the scene has no panels.
  std::size_t frames = 0;       ///< Number of samples.
  std::vector<double> flips{};  ///< flipsOf(): as many as half-turns. [s]
  double lowestEnergy = 1;
  double highestEnergy = 1;
  /// Largest Sample::errorDeg; nothing for Model::Exact, which is what it is measured against.
  /// [degrees]
  std::optional<double> errorDeg{};
  /// Time of the first error above kVisibleErrorDeg. [s]
  std::optional<double> visibleFrom{};
  std::optional<double> divergedAt{};  ///< Trajectory::divergedAt [s]
  bool divergesUnexpectedly = false;   ///< scene::divergesUnexpectedly()
  bool isJudged = true;  ///< False if nothing is expected of it, whatever the scene says.
  std::vector<scene::ExpectationResult> expectations{};
  std::vector<std::string> notes{};  ///< regimeNote(), if any; notesOn() has those on the settings.

  /// Returns whether all expectations are met and no divergence is unexpected.
  bool met() const;
};

/// Returns the times of all half-turns by physics::halfTurnTime(), ascending. [s]
std::vector<double> flipsOf(const physics::Trajectory& trajectory);

/// Returns what `trajectory`, simulated from `motion`, did.
MotionSummary summarize(const scene::Panel& motion, const physics::Trajectory& trajectory);

/// Returns a summary of each motion of `scene`, in the order of Scene::motions.
std::vector<MotionSummary> summarize(const scene::Scene& scene, const ClipMotion& motion);

/// Leaves out whatever was expected.
void leaveUnjudged(std::vector<MotionSummary>& motions);

/// Returns whether all are MotionSummary::met().
bool allMet(const std::vector<MotionSummary>& motions);

}  // namespace rotatebook::timeline
