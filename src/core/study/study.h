// Studies: a scene's motion run again and again, with other integrators and steps, or with other
// tilts. Those over any key are in study/sweep.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physics/motion_settings.h"
#include "scene/scene.h"
#include "scene/study_settings.h"
#include "study/execution.h"
#include "study/order_fit.h"

namespace rotatebook::study {

/// The results of one integrator with one step. Numbers are NaN if the run didn't reach its end;
/// the largest ones are over the frames.
struct PrecisionRow {
  physics::Integrator integrator = physics::Integrator::Euler;
  double h = 0;            ///< Step. [s]
  std::int64_t steps = 0;  ///< Total number.
  RunEnd end{};
  double errorDeg = kNoNumber;       ///< Largest Sample::errorDeg. [degrees]
  double finalErrorDeg = kNoNumber;  ///< The last Sample::errorDeg. [degrees]
  double energyDrift = kNoNumber;    ///< Largest |E/E0 - 1|.
  double momentumDrift = kNoNumber;  ///< Largest ||L|/|L0| - 1|.
  int halfTurns = 0;                 ///< Only of a whole run.
  double nsPerStep = kNoNumber;      ///< Measured by Execution; all else is computed. [ns]
};

/// The order that an integrator's rows show.
struct IntegratorOrder {
  physics::Integrator integrator = physics::Integrator::Euler;
  OrderFit fit;
};

struct PrecisionStudy {
  std::vector<PrecisionRow> rows;       ///< Integrator by integrator, in the order of the settings.
  std::vector<IntegratorOrder> orders;  ///< One for each integrator.
};

/// The results of one tilt. Numbers are NaN if there is no interval.
struct TiltRow {
  double tilt = 0;  ///< [rad]
  RunEnd end{};
  int flips = 0;                ///< physics::flipTimes()
  double interval = kNoNumber;  ///< Mean time from a flip to the next. [s]
  double law = 0;               ///< physics::asymptoticFlipInterval() [s]

  double ratio() const { return interval / law; }
};

struct TiltStudy {
  std::vector<TiltRow> rows;  ///< In the order of the settings.

  /// Returns the greatest |ratio - 1|; NaN if a row has no interval.
  double greatestDeviation() const;
};

/// Throws InputError if the scene has panels, the model takes no steps, or the study only one
/// sample of a motion.
void requireStudyable(const scene::Scene& scene, const scene::StudySettings& study);

/// Runs the scene's motion with each integrator and each step of `study`. Returns nothing after a
/// stop. Everything but the times is the same however the runs are made. Throws like
/// requireStudyable(), and like physics::simulate() except StepError.
std::optional<PrecisionStudy> runPrecisionStudy(const scene::Scene& scene,
                                                const scene::StudySettings& study,
                                                const Execution& execution);

/// Runs the scene's motion from each tilt of `study`. Returns nothing after a stop. Throws like
/// physics::simulate() except StepError.
std::optional<TiltStudy> runTiltStudy(const scene::Scene& scene, const scene::StudySettings& study,
                                      const Execution& execution);

}  // namespace rotatebook::study
