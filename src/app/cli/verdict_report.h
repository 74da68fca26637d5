// Reports on verdicts: as text, as JSON and as JUnit's XML. Inside the room only.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "physics/motion_settings.h"
#include "physics/trajectory.h"
#include "timeline/verdict.h"

namespace rotatebook::cli {

/// Bounds on a verdict. Nothing is expected of what has none.
struct VerdictBounds {
  std::optional<double> errorDeg{};       ///< On the largest error, >= 0. [degrees]
  std::optional<double> energyDrift{};    ///< On the largest drift's size, >= 0.
  std::optional<double> momentumDrift{};  ///< Likewise, of |L|.
  bool halfTurns = false;                 ///< As many as are due.
};

/// A verdict on a motion.
struct JudgedMotion {
  std::string name;  ///< The file's, with the panel's label.
  timeline::Verdict verdict{};
  /// The mistake in the table, or what it lacks, so that its motion isn't judged; empty without.
  std::string mistake{};
  std::vector<std::string> notes{};  ///< RecordedMotion::notes() of a recording.
};

/// Returns a verdict on `motion` for a report.
JudgedMotion judgedMotion(const std::string& name, const physics::MotionSettings& motion,
                          const physics::Trajectory& trajectory);

/// A bound, and whether a verdict keeps it.
struct BoundResult {
  std::string name;  ///< "error_deg"
  std::string text;  ///< "at most 1; measured 0.3"
  bool met = false;
};

/// Returns the results of the bounds that there are.
std::vector<BoundResult> resultsOf(const timeline::Verdict& verdict, const VerdictBounds& bounds);
/// Returns whether all motions are judged and keep all bounds.
bool allMet(const std::vector<JudgedMotion>& motions, const VerdictBounds& bounds);

/// Prints a few lines for each motion: what it does, what it ought to, and what errs so.
void reportVerdicts(const std::vector<JudgedMotion>& motions, const VerdictBounds& bounds,
                    std::ostream& out);
/// Prints one JSON object.
void reportVerdictsAsJson(const std::vector<JudgedMotion>& motions, const VerdictBounds& bounds,
                          std::ostream& out);
/// The beginning of JUnit's XML.
inline constexpr std::string_view kJunitBeginning =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";

/// Returns a document of JUnit's XML: a test suite for each motion, with a test case for each
/// bound; without bounds, one that passes; of a table that isn't judged, one that fails.
std::string junitOf(const std::vector<JudgedMotion>& motions, const VerdictBounds& bounds);

}  // namespace rotatebook::cli
