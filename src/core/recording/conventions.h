// The conventions of a table: axes, units and order of what it holds.
#pragma once

#include <string>
#include <vector>

#include "recording/recorded_motion.h"
#include "recording/unit_advice.h"

namespace rotatebook::recording {

/// Relative difference from which given rates contradict the attitudes beside them. Steps of order
/// 1 make 0.09 at 12 steps a turn, measured. [-]
inline constexpr double kContradicts = 0.3;

/// Comparison of given rates with the slopes of the attitudes beside them.
struct RateComparison {
  /// Root mean square of the rates minus the slopes, relative to the slopes' own; 0 where there are
  /// too few attitudes, or they are too far apart, to tell. [-]
  double difference = 0;
  /// The mistake in the table, and the remedy, if there is one; empty without a mistake.
  std::string mistake{};
  RateFit fit{};
};

/// Returns by what rates differ that are off: "are 1.02 times the attitudes' slopes".
std::string textOf(const RateFit& fit);

/// Compares the rates of moments with the slopes of their attitudes, both as a table was read:
/// along the body's axes if `areAlongBody`, else along the world's. If they differ, tries the other
/// axes, quaternions of body from world or in another order, other units, columns that are swapped
/// or negated, and turned axes. If they differ by more than kContradicts and none fits, or few
/// attitudes are apart though the rates turn the body, that is the mistake. Moments in between of
/// which the body turns by less than 0.1 rad are left out, so that noise of the attitudes matters
/// little.
RateComparison compareRates(const std::vector<RecordedMoment>& moments, bool areAlongBody,
                            const TableUnits& units = {});

}  // namespace rotatebook::recording
