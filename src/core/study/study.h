// Studies: a scene's motion run again and again with other values of one key or two, and what is
// measured of each run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/study_settings.h"
#include "study/execution.h"
#include "study/order_fit.h"
#include "study/run_value.h"

namespace rotatebook::study {

/// The results of one run. Numbers are NaN if the run didn't reach its end, but for diverges_at.
struct StudyRow {
  std::string value;  ///< As in scene::StudyRun.
  std::string curve;  ///< As in scene::StudyRun.
  RunEnd end{};
  double length = 0;  ///< Simulated time of a run that doesn't end early. [s]
  double step = 0;    ///< Length of a step. [s]
  /// In the order of scene::StudySettings::measures; the largest error in the place of an order.
  std::vector<double> measured{};
  double nsPerStep = kNoNumber;  ///< With an order; measured by Execution. [ns]
};

/// The order that the runs of a curve show.
struct CurveOrder {
  std::string curve;
  OrderFit fit;
};

struct Study {
  std::vector<StudyRow> rows;        ///< In the order of scene::StudySettings::runs.
  std::vector<CurveOrder> orders{};  ///< One for each curve, if orders are measured.
};

/// A number that is expected of a run, or of a curve.
struct StudyExpectation {
  scene::Expectation expectation;
  std::string value;  ///< As in StudyRow; empty of an order.
  std::string curve;  ///< As in StudyRow.
  double measured = kNoNumber;

  bool isMet() const { return expectation.bounds().hold(measured); }
  /// Returns "diverges_at at 10, matrix", or "order of euler".
  std::string subject() const;
};

/// Makes the runs of a scene's study; `scene.study` must be present. Returns nothing after a stop.
/// Everything but the computing times is the same however the runs are made. Throws like
/// physics::simulate() except StepError.
std::optional<Study> runStudy(const scene::Scene& scene, const Execution& execution);

/// Returns all that `study` expects, run by run for each of its expectations.
std::vector<StudyExpectation> expectedOf(const Study& result, const scene::StudySettings& study);

/// Returns the place of `measure` in StudyRow::measured; nothing if the study doesn't measure it.
std::optional<std::size_t> placeOf(scene::Measure measure, const scene::StudySettings& study);

}  // namespace rotatebook::study
