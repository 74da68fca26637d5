// Sweeps: a scene's motion run with other values of any key, and what is measured of each run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/study_settings.h"
#include "study/execution.h"
#include "study/reduced.h"

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
  scene::Expectation expectation;
  std::string value;  ///< As in SweepRow.
  std::string curve;  ///< As in SweepRow.
  double measured = kNoNumber;

  bool isMet() const { return expectation.bounds().hold(measured); }
  /// Returns "diverges_at at 10, matrix".
  std::string subject() const;
};

/// Makes the runs of a scene's sweep; `scene.study` has one. Of a run that doesn't reach its end
/// only diverges_at is measured, and the others are NaN. Returns nothing after a stop. Throws like
/// physics::simulate() except StepError.
std::optional<SweepStudy> runSweep(const scene::Scene& scene, const scene::StudySettings& study,
                                   const Execution& execution);

/// Returns all that `sweep` expects, run by run for each of its expectations.
std::vector<ExpectedOfRun> expectedOf(const SweepStudy& result, const scene::Sweep& sweep);

}  // namespace rotatebook::study
