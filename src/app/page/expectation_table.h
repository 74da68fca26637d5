// Tables of expected and measured values. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "page/html.h"
#include "scene/expectation.h"

namespace rotatebook::page {

/// Significant digits of a measured number, unless it takes more to tell it from its bound.
inline constexpr int kCheckDigits = 4;

/// A row: a quantity, what was expected and measured of it, and whether that is as expected.
struct Check {
  std::string subject;
  std::string expected;
  std::string measured;
  bool met = false;
  std::string meaning{};  ///< Of the quantity, in plain words.
};

/// Returns the row of an expectation on a motion.
Check checkOf(const scene::ExpectationResult& result, const Language& say = {});

/// Returns the row of a motion that diverges though nobody expected it. [s]
Check unexpectedDivergence(double time, const Language& say = {});

/// Returns the row of one number.
Check checkOf(const std::string& subject, const scene::Bounds& bounds, double measured,
              const std::string& meaning, const Language& say = {});

/// Returns the checks as a table with `caption`; empty if there are none.
Html checksTable(const std::string& caption, const std::vector<Check>& checks,
                 const Language& say = {});

/// Returns "4 of 5 expectations met" as a badge; empty if all are met.
Html unmetBadge(const std::vector<Check>& checks, const Language& say = {});

/// Returns `tables`, which hold all of `checks`, folded below "5 of 5 expectations met"; unfolded
/// if a check is unmet. Empty if there are no checks.
Html foldedChecks(const std::vector<Check>& checks, const Html& tables, const Language& say = {});

}  // namespace rotatebook::page
