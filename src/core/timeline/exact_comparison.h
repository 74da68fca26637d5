// A motion beside the exact one, and what of it changes. Inside the room only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "physics/motion_settings.h"
#include "physics/sample.h"
#include "timeline/drift.h"
#include "timeline/verdict.h"

namespace rotatebook::timeline {

/// Returns the exact motion at the times of `samples`.
std::vector<physics::Sample> exactAt(physics::MotionSettings motion,
                                     const std::vector<physics::Sample>& samples);

/// A motion beside an exact one, sample by sample.
struct Comparison {
  std::vector<double> times{};                ///< [s]
  std::vector<double> energy{}, momentum{};   ///< As parts of the exact motion's.
  std::vector<double> errorDeg{}, turnDeg{};  ///< Of the attitude, and of L. [degrees]
};

/// Compares motions; the parts are 1 where the exact motion is at rest after a nudge.
Comparison compared(const std::vector<physics::Sample>& samples,
                    const std::vector<physics::Sample>& exact);

/// Makes energy and momentum relative to the first of the inner.
void relateToFirst(Comparison& comparison, const Verdict& verdict);

/// Returns the values without the two at each end, whose slopes are one-sided, if they are slopes.
template <typename Value>
std::span<const Value> inner(const std::vector<Value>& values, const Verdict& verdict) {
  const bool areSlopes = verdict.spins.source == recording::SpinSource::Slopes;
  const std::size_t left = areSlopes && values.size() > 8 ? 2 : 0;
  return std::span(values).subspan(left, values.size() - 2 * left);
}

/// Sets the errors to those from the exact motion, and returns their noise. [degrees]
double setErrors(Comparison& comparison, const std::vector<physics::Sample>& samples,
                 const std::vector<physics::Sample>& exact);

/// Sets what the verdict measures.
void takeMeasures(const Comparison& comparison, const std::vector<physics::Sample>& exact,
                  Verdict& verdict);

/// Returns of how many samples the means are taken so that noise matters little: 1 without noise.
std::size_t samplesAMean(double scatter, std::size_t count);

/// Changes of energy and of the size of L, and bounds up to which they count as kept.
struct Changes {
  Drift energy{}, momentum{};                     ///< Of means over samplesAMean().
  double energyScatter = 0, momentumScatter = 0;  ///< scatterOf() the samples.
  double energyBound = kKept, momentumBound = kKept;
  double ofASample = kKept;  ///< A bound on what noise turns a sample's L by. [rad]

  /// Returns the noise of a sample's size of L, relative.
  double scatter() const { return std::max(energyScatter / 2, momentumScatter); }
  bool keepEnergy() const { return energy.range < energyBound; }
  bool keepMomentum() const {
    // A swing beside a trend of the energy that is ten times as large is no change of its own.
    const bool isBeside = energy.isTrend() && !momentum.isTrend();
    return momentum.range < std::max(momentumBound, isBeside ? energy.range / 10 : 0);
  }
};

Changes changesIn(const Comparison& comparison, const Verdict& verdict);

}  // namespace rotatebook::timeline
