// Expected against measured, as a table. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "page/html.h"
#include "page/motion_data.h"

namespace rotatebook::page {

/// Of a measured number, unless it takes more to tell it from its bound.
inline constexpr int kCheckDigits = 4;

/// One row: what was expected of something, what was measured, and whether that is as expected.
struct Check {
  std::string subject;
  std::string expected;
  std::string measured;
  bool met = false;
};

/// What became of a motion: its divergence if there was one that nobody expected, and each of its
/// expectations.
std::vector<Check> checksOf(const Motion& motion);

/// The checks as a table with `caption`; nothing if there are none.
Html checksTable(const std::string& caption, const std::vector<Check>& checks);

/// "4 of 5 expectations met" as a badge; nothing if all are.
Html unmetBadge(const std::vector<Check>& checks);

/// `tables` to be unfolded below "5 of 5 expectations met"; unfolded if one of `checks`, which are
/// all that is in them, is unmet. Nothing if there are none.
Html foldedChecks(const std::vector<Check>& checks, const Html& tables);

}  // namespace rotatebook::page
