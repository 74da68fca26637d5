// Studies: a scene's motion run again and again, with other integrators and steps, or with other
// tilts. Those over any key are in study/sweep.h.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/motion_settings.h"
#include "scene/scene.h"
#include "scene/study_settings.h"
#include "study/order_fit.h"

namespace rotatebook::study {

inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The outcome of a run.
struct RunEnd {
  enum class Kind {
    Whole,
    Diverged,       ///< Trajectory::divergedAt
    NoConvergence,  ///< physics::NoConvergence
    StepTooLong,    ///< physics::StepTooLong
    FewFlips,       ///< Whole, but with fewer than two flips, so without an interval.
  };

  Kind kind = Kind::Whole;
  double time = 0;  ///< Time of divergence; for FewFlips, the motion's length. [s]

  /// Returns "ok", "diverged at 1.2 s", "no convergence", "step too long for its series" or "fewer
  /// than two flips in 60 s".
  std::string text() const;
};

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

/// Makes one run of a study, given its index.
using Run = std::function<void(std::size_t)>;

/// Makes the runs `indices` on the caller's thread, in their order. Returns true.
bool runInTurn(std::span<const std::size_t> indices, const Run& run);

/// The functions that make the runs of a study and measure their time. The core starts no thread
/// and reads no clock; its caller may.
struct Execution {
  /// Calls the run once with each of the indices, started in their order, possibly several at a
  /// time. Returns whether all were made; throws the first error that a run threw.
  std::function<bool(std::span<const std::size_t>, const Run&)> runAll = runInTurn;
  /// Measures the computing time of one step within a motion's first `steps` steps. [ns] Without
  /// it, PrecisionRow::nsPerStep is NaN.
  std::function<double(const physics::MotionSettings&, std::int64_t steps)> nanosecondsPerStep{};
  /// Stops the study if set from outside; read at every frame. May be null.
  const std::atomic<bool>* stop = nullptr;
};

/// Throws InputError if the scene has panels, the model takes no steps, or the clip has only one
/// frame.
void requireStudyable(const scene::Scene& scene);

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
