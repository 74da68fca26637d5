// A verdict on a motion: how it differs from the exact one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "physics/motion_settings.h"
#include "physics/trajectory.h"
#include "rigid/regime.h"

namespace rotatebook::timeline {

/// Kinds of errors of a motion, as hints to the method that made it.
enum class Errs {
  Hardly,          ///< By less than kAgreesDeg.
  SpinIsFixed,     ///< The angular velocity stays as it was, along the world's axes.
  InPhase,         ///< Energy and the size of L stay.
  GainsEnergy,     ///< The size of L stays, the energy grows.
  LosesEnergy,     ///< The size of L stays, the energy falls.
  GainsBoth,       ///< Energy grows, and L changes.
  LosesBoth,       ///< Energy falls, and L with it.
  Inconsistently,  ///< Energy falls while L grows.
};

/// Largest error of motions that agree with the exact one. [degrees]
inline constexpr double kAgreesDeg = 0.5;
/// Relative drift up to which energy, the size of L and the spin count as kept.
inline constexpr double kKept = 1e-3;

/// A motion's differences from the exact one from the same start.
struct Verdict {
  std::size_t samples = 0;
  double duration = 0;                  ///< [s]
  double endErrorDeg = 0;               ///< Sample::errorDeg of the last sample. [degrees]
  double errorDeg = 0;                  ///< The largest. [degrees]
  std::optional<double> visibleFrom{};  ///< Time of the first error above kVisibleErrorDeg. [s]
  double endEnergyDrift = 0;            ///< E/E0 - 1 of the last sample.
  double energyDrift = 0;               ///< The largest on the way, with its sign.
  double endMomentumDrift = 0;          ///< |L|/|L0| - 1 of the last sample.
  double momentumDrift = 0;             ///< Likewise the largest.
  double momentumTurnDeg = 0;           ///< Largest angle from L to L at the start. [degrees]
  int halfTurns = 0;                    ///< Made by the motion.
  int halfTurnsDue = 0;                 ///< Made by the exact one.
  rigid::Regime start = rigid::Regime::Separatrix, end = rigid::Regime::Separatrix;
  Errs errs = Errs::Hardly;
};

/// Judges `trajectory`, which was simulated or recorded from `motion`. Throws InputError as
/// physics::simulate() does.
Verdict judge(const physics::MotionSettings& motion, const physics::Trajectory& trajectory);

/// Returns what the motion does, and the kind of rigid method that errs so.
std::string methodThat(Errs errs);

}  // namespace rotatebook::timeline
