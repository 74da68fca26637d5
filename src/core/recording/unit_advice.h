// Advice on units that a table may be in.
#pragma once

#include <string>

namespace rotatebook::recording {

/// The units that a table is read in, and what attitudes it has.
struct TableUnits {
  double seconds = 1;           ///< A unit of its times. [s]
  double radians = 1;           ///< A unit of its rates. [rad/s]
  bool haveQuaternions = true;  ///< Else matrices.
};

/// Returns that rates, read in `units`, are `factor` times the attitudes' slopes, and the units to
/// state so that they are the same.
std::string factorText(double factor, const TableUnits& units);

}  // namespace rotatebook::recording
