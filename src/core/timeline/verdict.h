// A verdict on a motion: how it differs from the exact one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recording/recorded_motion.h"
#include "rigid/regime.h"

namespace rotatebook::timeline {

/// Kinds of errors of a motion, as hints to the method that made it.
enum class Errs {
  Hardly,           ///< Attitude, energy, L and half-turns are the exact motion's.
  HardlyAsFitted,   ///< Likewise, from a start within the uncertainty of the recording's spins.
  RatesAreOff,      ///< The attitudes alone agree; the angular velocities aren't their slopes.
  SpinsAreOthers,   ///< The angular velocities aren't the attitudes' slopes.
  SpinIsFixed,      ///< The angular velocity stays as it was, along the world's axes.
  InPhase,          ///< Energy and L stay.
  TurnsSlightly,    ///< Energy and the size of L stay; L turns by more than an agreeing motion's.
  TooFewRows,       ///< Less than kLeastRows of a recording; nothing else is said of it.
  TooFewAttitudes,  ///< So far apart that their slopes aren't the angular velocities.
  TooFewReadings,   ///< Of rates alone, whose turns between aren't known as well as they differ.
  TurnsMomentum,    ///< L turns in the world, by more than kTurnsDeg.
  Swings,           ///< Energy or the size of L goes away and comes back.
  GainsEnergy,      ///< The size of L stays, the energy grows.
  LosesEnergy,      ///< The size of L stays, the energy falls.
  GainsMomentum,    ///< The energy stays, L grows.
  LosesMomentum,    ///< The energy stays, L falls.
  GainsBoth,        ///< Energy grows, and L changes.
  LosesBoth,        ///< Energy falls, and L with it.
  Inconsistently,   ///< Energy falls while L grows.
};

/// Largest error of motions that agree with the exact one. [degrees]
inline constexpr double kAgreesDeg = 0.5;
/// Relative change up to which energy, the size of L and the spin count as kept, beside what the
/// scatter of the values and the uncertainty of slopes make of it.
inline constexpr double kKept = 1e-3;
/// Angle by which L turns in the world with another convention, another inertia or an outer torque.
/// Explicit steps of order 1, 60 a turn, make 3 degrees, measured. [degrees]
inline constexpr double kTurnsDeg = 10;

/// Fewest rows of a recording that is judged: a fit of its start takes as many.
inline constexpr std::size_t kLeastRows = 12;

/// A motion's differences from the exact one from the same start or, of Errs::HardlyAsFitted, from
/// one that is fitted. Energy and L are relative to the exact motion's, which nudges change; where
/// spins are slopes of attitudes, without the two at each end, which are one-sided.
struct Verdict {
  bool isRecorded = false;  ///< Apart from the inertia.
  std::size_t samples = 0;
  double duration = 0;                  ///< [s]
  double endErrorDeg = 0;               ///< Sample::errorDeg of the last sample. [degrees]
  double errorDeg = 0;                  ///< The largest, a stray row's, too. [degrees]
  std::optional<double> visibleFrom{};  ///< Time of the first error above kVisibleErrorDeg. [s]
  double endEnergyDrift = 0;            ///< E/E0 - 1 of the last sample.
  double energyDrift = 0;               ///< The largest on the way, with its sign.
  double endMomentumDrift = 0;          ///< |L|/|L0| - 1 of the last sample.
  double momentumDrift = 0;             ///< The largest on the way, with its sign.
  double momentumTurnDeg = 0;           ///< Largest angle from L to the exact motion's. [degrees]
  int halfTurns = 0;                    ///< Made by the motion.
  int halfTurnsDue = 0;                 ///< Made by the exact one.
  rigid::Regime start = rigid::Regime::Separatrix, end = rigid::Regime::Separatrix;
  /// Noise of a sample's energy or size of L, relative: of the spins and attitudes recorded.
  double scatter = 0;
  /// Relative change of the start's spin by the fit; nothing unless Errs::HardlyAsFitted.
  std::optional<double> fittedBy{};
  /// RecordedMotion::flaws() of one that is judged without them; else empty.
  std::vector<std::string> flaws{};
  recording::SpinFacts spins{};  ///< Of a recording; of other motions, the spins are given.
  Errs errs = Errs::Hardly;
};

/// Returns whether the motion agrees with the exact one, by all that is recorded.
bool agreesWithExact(const Verdict& verdict);
/// Returns whether the recording tells enough.
bool isJudged(const Verdict& verdict);

/// Returns by what rates beside attitudes differ from their slopes: "are 1.02 times the attitudes'
/// slopes".
std::string ratesText(const recording::SpinFacts& spins);
/// Returns what the motion does, or why it isn't judged, and the kind of rigid method that errs so.
std::string methodThat(const Verdict& verdict);

}  // namespace rotatebook::timeline
