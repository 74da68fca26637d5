#include "recording/sensor_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>
#include <string_view>

#include "base/number_text.h"
#include "base/text.h"
#include "recording/column_units.h"
#include "recording/gaps.h"

namespace rotatebook::recording {
namespace {

constexpr double kLargestTime = 1e12;  // [s]

using Indices = std::vector<std::size_t>;

template <typename Group>
void append(Indices& columns, const Group& group) {
  if (group) columns.insert(columns.end(), group->begin(), group->end());
}

/// Returns the first column with a hole in `row`; nothing if all are filled.
std::optional<std::size_t> holeIn(const CsvTable& table, std::size_t row, const Indices& columns) {
  const auto hole =
      std::ranges::find_if(columns, [&](std::size_t column) { return table.isHole(row, column); });
  return hole != columns.end() ? std::optional(*hole) : std::nullopt;
}

Indices filledRows(const CsvTable& table, const Indices& columns) {
  Indices rows;
  if (columns.size() == 1) return rows;  // the time alone
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!holeIn(table, row, columns)) rows.push_back(row);
  }
  return rows;
}

/// Throws InputError for a table in which no row has all of a sensor's numbers.
[[noreturn]] void failEmpty(const CsvTable& table, const Indices& columns) {
  for (const std::size_t column : columns) {
    const Indices filled = filledRows(table, {column, column});
    if (!filled.empty()) continue;
    table.fail("the column " + quotedText(table.header()[column]) +
               " has no number in any row; export it with them, or name another in "
               "simulation.columns, or with --column");
  }
  table.fail("no row has all of the numbers that are read");
}

/// Throws InputError for a hole between the first and the last of a sensor's rows.
void requireWhole(const CsvTable& table, const Indices& rows, const Indices& columns) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::size_t row = rows[i - 1] + 1;
    if (row < rows[i]) table.at(row, holeIn(table, row, columns).value());
  }
}

/// Returns whether two sensors have times of their own: at most half of the rows have both.
bool areMerged(const Indices& first, const Indices& second) {
  Indices both;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                        std::back_inserter(both));
  return 2 * both.size() <= first.size() + second.size() - both.size();
}

[[noreturn]] void failTimeUnit(const CsvTable& table, const Columns& columns,
                               const std::string& problem, double step, double last) {
  const std::string& header = table.header()[columns.time];
  const std::string_view unit = plausibleUnit(step, last);
  const std::string remedy = unit.empty() ? "state it in simulation.time_unit, or with --time-unit"
                                          : "it seems to be " + std::string(unit) +
                                                ": state it in simulation.time_unit, "
                                                "or with --time-unit " +
                                                std::string(unit);
  table.fail("the column " + quotedText(header) + " doesn't state its unit, and in seconds " +
             problem + "; " + remedy);
}

/// Refuses times that aren't seconds though no unit is stated.
void requirePlausibleSteps(const CsvTable& table, const Columns& columns,
                           const std::vector<double>& times, double zero) {
  constexpr double kLongestStep = 2;  // [s]
  constexpr double kLatest = 4e9;     // of an epoch, in the year 2096 [s]
  if (columns.isTimeUnitStated || times.size() < 2) return;
  const double step = medianStep(times), last = std::abs(zero + times.back());
  if (step > kLongestStep) {
    failTimeUnit(table, columns, "its rows are " + roundedText(step, 3) + " s apart", step, last);
  }
  if (last > kLatest)
    failTimeUnit(table, columns, "it ends at " + roundedText(last, 3) + " s", step, last);
}

/// Returns the time of a row after `zero`. [s]
double timeAt(const CsvTable& table, const Columns& columns, std::size_t row, double zero) {
  const double beside = columns.nanoseconds ? 1e-9 * table.at(row, *columns.nanoseconds) : 0;
  const double time = columns.secondsPerUnit * table.at(row, columns.time);
  const std::optional<Decimal> units = table.decimalAt(row, columns.time);
  const double unitsASecond = std::round(1 / columns.secondsPerUnit);
  constexpr double kLargest = 4.5e18;  // whose differences have 63 bits
  const bool isExact = units && unitsASecond >= 1 && std::abs(zero) * unitsASecond < kLargest &&
                       std::abs(static_cast<double>(units->whole)) < kLargest;
  if (zero == 0 || !isExact) return time - zero + beside;
  const std::int64_t whole =
      units->whole - static_cast<std::int64_t>(zero) * static_cast<std::int64_t>(unitsASecond);
  return columns.secondsPerUnit * (static_cast<double>(whole) + units->rest) + beside;
}

}  // namespace

SensorRows sensorRows(const CsvTable& table, const Columns& columns, bool needsForce) {
  Indices motion{columns.time}, force{columns.time};
  append(motion, columns.quaternion);
  append(motion, columns.matrix);
  append(motion, columns.rates);
  append(force, columns.acceleration);
  SensorRows result{filledRows(table, motion), filledRows(table, force)};
  const bool hasMotion = motion.size() > 1;
  const bool isMerged = hasMotion && columns.acceleration && areMerged(result.motion, result.force);
  if (hasMotion && !isMerged) requireWhole(table, result.motion, motion);
  if (needsForce && !isMerged) requireWhole(table, result.force, force);
  const Indices& needed = hasMotion ? result.motion : result.force;
  if (needed.empty()) failEmpty(table, hasMotion ? motion : force);
  if (table.isText(needed.front(), columns.time))
    table.at(needed.front(), columns.time, "write seconds, as since the start");
  const Indices others = isMerged ? result.force : Indices{};
  Indices all;
  std::set_union(result.motion.begin(), result.motion.end(), others.begin(), others.end(),
                 std::back_inserter(all));
  if (isMerged) requireWhole(table, all, motion);
  result.dropped = table.rows() - (hasMotion ? all.size() : needed.size());
  return result;
}

double zeroOf(const CsvTable& table, const Columns& columns, std::size_t row) {
  constexpr double kResolved = 1 << 20;  // to 1e-10 s
  const double first = columns.secondsPerUnit * table.at(row, columns.time);
  return std::abs(first) < kResolved || std::abs(first) > kLargestTime ? 0 : std::floor(first);
}

std::vector<double> timesOf(const CsvTable& table, const Columns& columns, const Indices& rows,
                            double zero) {
  std::vector<double> times;
  for (const std::size_t row : rows) times.push_back(timeAt(table, columns, row, zero));
  if (times.size() < 2) table.fail("a single row; a motion takes at least two");
  requirePlausibleSteps(table, columns, times, zero);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double time = zero + times[i];
    if (!(std::abs(time) <= kLargestTime)) table.failAt(rows[i], "the time is beyond 1e12 s");
    const double gap = i == 0 ? 1 : times[i] - times[i - 1];
    if (!(gap > 0)) {
      const std::string relation =
          gap == 0 ? " s is that of the row before, too" : " s isn't after that of the row before";
      table.failAt(rows[i], "the time " + shortestText(time) + relation +
                                "; write times that ascend, with all their digits, or leave such "
                                "rows out");
    }
    // Beyond rounding, so that slopes between neighbours are finite.
    if (!(gap > 1e-15 * std::abs(times[i]) && gap > 1e-9)) {
      table.failAt(rows[i], "the time " + shortestText(time) + " s is only " + roundedText(gap, 2) +
                                " s after that of the row before");
    }
  }
  return times;
}

void requirePlausibleTurns(const CsvTable& table, const Columns& columns,
                           const std::vector<Rate>& rates) {
  // Steps of a sensor. Shorter ones are simulated, or in minutes, in which throws seem to turn the
  // body by little. [s]
  constexpr double kSlowest = 0.2, kShortest = 5e-4;
  constexpr std::size_t kMinRows = 50;
  if (columns.isTimeUnitStated) return;
  std::vector<double> times;
  double fastest = 0, path = 0;
  for (const Rate& rate : rates) {
    const double speed = rate.angularVelocity.norm();
    fastest = std::max(fastest, speed);
    if (!times.empty()) path += speed * (rate.time - times.back());
    times.push_back(rate.time);
  }
  const double step = medianStep(times), turn = fastest * step, last = std::abs(times.back());
  if (step < kShortest && times.size() >= kMinRows && path < std::numbers::pi) {
    failTimeUnit(table, columns,
                 "its rows are " + roundedText(step, 3) + " s apart and the body turns by " +
                     roundedText(path, 2) + " rad in all",
                 step, last);
  }
  if (step <= kSlowest || !(turn > std::numbers::pi)) return;
  failTimeUnit(table, columns,
               "the body turns by up to " + roundedText(turn, 3) + " rad from row to row", step,
               last);
}

}  // namespace rotatebook::recording
