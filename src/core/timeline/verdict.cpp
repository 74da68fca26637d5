#include "timeline/verdict.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "base/number_text.h"
#include "base/text.h"
#include "recording/conventions.h"

namespace rotatebook::timeline {
namespace {

/// Returns the kind of a motion whose verdict has no numbers; empty of others.
std::string_view plainKindOf(Errs errs) {
  switch (errs) {
    case Errs::Hardly:
      return "agrees with the exact motion";
    case Errs::HardlyAsFitted:
      return "agrees with the exact motion, from a start within the uncertainty of its spins";
    case Errs::SpinIsFixed:
      return "keeps the angular velocity fixed in the world, as without a gyroscopic torque";
    case Errs::Swings:
      return "swings in energy or angular momentum, which come back: another inertia than that of "
             "the body that moved, or angular velocities with a bias, or of other moments than the "
             "attitudes";
    case Errs::GainsEnergy:
      return "keeps the angular momentum and gains energy, as explicit steps of the attitude do";
    case Errs::LosesEnergy:
      return "keeps the angular momentum and loses energy, as implicit steps do, or damping inside";
    case Errs::GainsMomentum:
      return "keeps the energy, and the angular momentum grows, as with velocities that are scaled "
             "to the energy";
    case Errs::LosesMomentum:
      return "keeps the energy, and the angular momentum falls, as with velocities that are scaled "
             "to the energy";
    case Errs::GainsBoth:
      return "gains energy, as with an explicit gyroscopic torque of order 1";
    case Errs::LosesBoth:
      return "loses energy and angular momentum, as with an implicit gyroscopic torque, or damping";
    case Errs::Inconsistently:
      return "loses energy while the angular momentum grows, as with a gyroscopic torque of order "
             "1 that doesn't fit the attitude's step";
    default:
      return "";
  }
}

/// Returns why attitudes alone aren't judged. Of noise, slopes to nearer neighbours have more.
std::string tooFewAttitudesText(const Verdict& verdict) {
  constexpr double kOfNoise = 0.7;  // of slopes, beside the noise of L
  if (kOfNoise * verdict.scatter > verdict.spins.uncertainty / 2) {
    return "its attitudes, or their times, are too uncertain from row to row for their slopes to "
           "be its angular velocities; keep fewer rows, so that it turns by about 10 degrees from "
           "one to the next, or record the angular velocities, too";
  }
  return "its attitudes are too far apart, or their times too uncertain, for their slopes to be "
         "its angular velocities; record more of them, or the angular velocities, too";
}

/// Returns whether energy or the size of L goes one way.
bool isTrend(Errs errs) {
  return errs == Errs::GainsEnergy || errs == Errs::LosesEnergy || errs == Errs::GainsMomentum ||
         errs == Errs::LosesMomentum || errs == Errs::GainsBoth || errs == Errs::LosesBoth ||
         errs == Errs::Inconsistently;
}

/// Returns whether it may be the inertia, and not the motion: one that is wrong by 1 % changes
/// energy and L by up to 1 %, which needn't have come back at the end.
bool mayBeInertia(const Verdict& verdict) {
  constexpr double kSmall = 0.02;
  const double change = std::max(std::fabs(verdict.energyDrift), std::fabs(verdict.momentumDrift));
  return verdict.isRecorded &&
         (verdict.errs == Errs::InPhase || (isTrend(verdict.errs) && change < kSmall));
}

/// Names the inertia, if it may be that, before the methods: "gains energy, as with ...".
std::string withCauses(const Verdict& verdict, std::string kind) {
  constexpr std::string_view kAs = ", as ";
  const std::size_t causes = kind.find(kAs);
  if (causes == kind.npos || !mayBeInertia(verdict)) return kind;
  return kind.insert(causes + kAs.size(), "with an inertia that is stated a little wrong, or as ");
}

std::string kindOf(const Verdict& verdict) {
  switch (verdict.errs) {
    case Errs::TooFewAttitudes:
      return tooFewAttitudesText(verdict);
    case Errs::SpinsAreOthers:
      return "has angular velocities that aren't the slopes of its attitudes, which differ from "
             "the exact motion's by up to " +
             roundedText(verdict.errorDeg, 2) + " degrees";
    case Errs::RatesAreOff:
      return "agrees with the exact motion by its attitudes alone; its angular velocities " +
             ratesText(verdict.spins);
    case Errs::InPhase:
      return withCauses(verdict,
                        "keeps energy and angular momentum, but not the pace, as with long steps") +
             (verdict.spins.fit.isOff()
                  ? ", or with rates of another scale: they " + ratesText(verdict.spins)
                  : std::string());
    case Errs::TurnsSlightly:
      return "keeps energy and the size of the angular momentum, which turns by up to " +
             roundedText(verdict.momentumTurnDeg, 3) +
             " degrees: attitudes that drift or jump, or rates along axes that are turned" +
             (verdict.spins.source == recording::SpinSource::Given
                  ? "; the rates " + ratesText(verdict.spins)
                  : std::string());
    case Errs::TooFewRows:
      return std::to_string(verdict.samples) + (verdict.samples == 1 ? " row is" : " rows are") +
             " too few to tell; record at least " + std::to_string(kLeastRows);
    case Errs::TooFewReadings:
      return "energy and the size of the angular momentum are the exact motion's, but its readings "
             "are so far apart that its attitude may be off by " +
             roundedText(verdict.spins.unknownTurn * 180 / std::numbers::pi, 2) +
             " degrees; record more of them, or state a part without gaps";
    case Errs::TurnsMomentum:
      return "turns the angular momentum by " + roundedText(verdict.momentumTurnDeg, 3) +
             " degrees: another convention, another inertia, or an outer torque";
    default:
      return withCauses(verdict, std::string(plainKindOf(verdict.errs)));
  }
}

}  // namespace

bool agreesWithExact(const Verdict& verdict) {
  return verdict.errs == Errs::Hardly || verdict.errs == Errs::HardlyAsFitted;
}

bool isJudged(const Verdict& verdict) {
  return verdict.errs != Errs::TooFewRows && verdict.errs != Errs::TooFewAttitudes &&
         verdict.errs != Errs::TooFewReadings;
}

std::string ratesText(const recording::SpinFacts& spins) {
  if (spins.fit.isOff()) return recording::textOf(spins.fit);
  return "differ from the attitudes' slopes by " + roundedText(100 * spins.difference, 2) + " %";
}

std::string methodThat(const Verdict& verdict) {
  const std::string kind = kindOf(verdict);
  if (verdict.flaws.empty()) return kind;
  const std::string flaws = joined(verdict.flaws, "; ");
  return isJudged(verdict) ? kind + ", but for its flaws: " + flaws
                           : flaws + "; and without that, " + kind;
}

}  // namespace rotatebook::timeline
