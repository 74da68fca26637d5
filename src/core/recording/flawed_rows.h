// Rows of a recording that aren't its motion's: single wrong ones, held and dropped ones. Inside
// the room only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recording/recorded_motion.h"

namespace rotatebook::recording {

/// A row whose attitude or rates are far off those that its neighbours make of it.
struct StrayRow {
  std::size_t index = 0;
  bool isAttitude = true;  ///< Else the rates.
  double off = 0;          ///< [rad], or of rates [rad/s]
};

/// Rows that are missing between two, though the times go on as before.
struct DroppedRows {
  std::size_t after = 0;  ///< Index of the row before.
  int count = 0;
};

/// The flaws of a recording.
struct Flaws {
  std::vector<StrayRow> stray{};
  /// Rows that repeat the attitude of the row before, in the midst of a motion.
  std::vector<std::size_t> held{};
  std::vector<DroppedRows> dropped{};

  /// Returns by how much the attitude of a stray row is off, at most. [rad]
  double largestTurn() const;
  bool areAny() const { return !stray.empty() || !held.empty() || !dropped.empty(); }
};

/// Finds the flaws of at least two moments: first what is held, then what is stray, then what is
/// dropped, each in what is left. Strays, one to three of them, are more than 12 times as far off
/// as half of the rows, and those beside them fit without them; of more than a twentieth of the
/// rows, none is one. Where rows are dropped, the body turns by a whole multiple of what it does
/// before and after. Nothing is said of a body that turns by more than 0.7 rad from row to row,
/// nor, but for stray rates, of a gyroscope's.
Flaws flawsIn(const std::vector<RecordedMoment>& moments, SpinSource source);

/// Returns the flaws in words, one kind each, where the first moment is at `zero` of the file's
/// times: "1 row is off its neighbours: the attitude at 3.2 s, by 40 degrees". [s]
std::vector<std::string> textsOf(const Flaws& flaws, const std::vector<RecordedMoment>& moments,
                                 double zero);

/// Returns the moments without stray and held rows, and those after dropped ones later by as many
/// steps; slopes and integrals are made anew.
std::vector<RecordedMoment> withoutFlaws(const Flaws& flaws,
                                         const std::vector<RecordedMoment>& moments,
                                         SpinSource source);

}  // namespace rotatebook::recording
