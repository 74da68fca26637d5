// Sweeps: a scene's motion run with other values of any key, and what is measured of each run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/trajectory.h"
#include "scene/study_settings.h"
#include "study/study.h"

namespace rotatebook::study {

/// The results of one run.
struct SweepRow {
  std::string value;  ///< As in scene::SweepRun.
  std::string curve;  ///< As in scene::SweepRun.
  RunEnd end{};
  double length = 0;               ///< Simulated time of a run that doesn't end early. [s]
  std::vector<double> measured{};  ///< In the order of scene::Sweep::measures.
};

struct SweepStudy {
  std::vector<SweepRow> rows;  ///< In the order of scene::Sweep::runs.
};

/// A number that is expected of a run.
struct ExpectedOfRun {
  scene::SweepExpectation expectation;
  std::string value;  ///< As in SweepRow.
  std::string curve;  ///< As in SweepRow.
  double measured = kNoNumber;

  bool isMet() const { return expectation.bounds.hold(measured); }
  /// Returns "diverges_at at 10, matrix".
  std::string subject() const;
};

/// Reduces a quantity of a whole motion to one number: half_turns to the number made, regime to the
/// last, ratios and stretch to the largest departure from 1, and others to the largest. diverges_at
/// is infinite.
double reduced(const physics::Trajectory& trajectory, scene::Quantity quantity);

/// Makes the runs of a scene's sweep; `scene.study` has one. Of a run that doesn't reach its end
/// only diverges_at is measured, and the others are NaN. Returns nothing after a stop. Throws like
/// physics::simulate() except StepError.
std::optional<SweepStudy> runSweep(const scene::Scene& scene, const scene::StudySettings& study,
                                   const Execution& execution);

/// Returns all that `sweep` expects, run by run for each of its expectations.
std::vector<ExpectedOfRun> expectedOf(const SweepStudy& result, const scene::Sweep& sweep);

/// Returns a header row and one row a run: the key, the key of the curves if there is one, each
/// measured quantity, status. A motion that doesn't diverge has "inf" for diverges_at.
std::string sweepCsv(const SweepStudy& result, const scene::Sweep& sweep);

}  // namespace rotatebook::study
