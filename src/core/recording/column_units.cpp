#include "recording/column_units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "base/text.h"
#include "recording/column_name.h"
#include "recording/column_spellings.h"
#include "recording/gaps.h"
#include "recording/unit_tables.h"
#include "recording/words.h"

namespace rotatebook::recording {
namespace {

/// Programs that write no units: by the header of the time in small letters, and if that is another
/// by ColumnName::plain, the units of times and rates. Of two with the same name, the first is that
/// whose rows are near enough each other.
struct Program {
  std::string_view time;
  double seconds;                                                // [s]
  double rates;                                                  // [rad/s]
  double longestStep = std::numeric_limits<double>::infinity();  // of times as they are written
};
constexpr double kDegree = std::numbers::pi / 180;
constexpr Program kPrograms[]{{"secondselapsed", 1, 1},           // Sensor Logger
                              {"sampletimefine", 1e-4, 1, 5000},  // Xsens MT Manager, from 2 Hz on
                              {"sampletimefine", 1e-6, kDegree},  // Xsens DOT, up to 120 Hz
                              {"%time", 1e-9, 1},                 // rostopic
                              {"field.header.stamp", 1e-9, 1},    // rostopic
                              {"stampsecs", 1, 1},                // ROS's messages
                              {"stampsec", 1, 1},
                              {"__time", 1, 1}};  // PlotJuggler

/// Returns the usual step of the times as they are written; 0 where there are no two numbers.
double stepWritten(const CsvTable& table, std::size_t column) {
  std::vector<double> times;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!table.isHole(row, column) && !table.isText(row, column))
      times.push_back(table.at(row, column));
  }
  return times.size() < 2 ? 0 : medianStep(times);
}

const Program* programOf(const CsvTable& table, const Columns& columns) {
  const std::string &header = table.header()[columns.time], small = lowerCase(header);
  const std::string name = columnNameOf(header).plain;
  const auto found = std::ranges::find_if(kPrograms, [&](const Program& program) {
    const bool isNamed = small == program.time || isTimeNamed(name, program.time);
    return isNamed && (std::isinf(program.longestStep) ||
                       stepWritten(table, columns.time) < program.longestStep);
  });
  return found != std::end(kPrograms) ? found : nullptr;
}

/// Returns the unit among the words of a time's name: "timeMs", "seconds_elapsed", "timeinms".
std::optional<double> timeUnitIn(const ColumnName& name) {
  for (auto word = name.words.rbegin(); word != name.words.rend(); ++word) {
    const bool isLetter = word->size() == 1 && word != name.words.rbegin();
    if (const auto unit = unitNamed(kUnitsOfTimes, *word); unit && !isLetter) return unit;
  }
  if (isAmong(kTimeNames, name.plain)) return std::nullopt;  // "ts" isn't t in seconds.
  for (const std::string_view usual : wordsOf(kTimeNames)) {
    if (!name.plain.starts_with(usual)) continue;
    std::string_view rest = std::string_view(name.plain).substr(usual.size());
    if (const auto unit = unitNamed(kUnitsOfTimes, rest)) return unit;
    if (rest.starts_with("in")) rest.remove_prefix(2);
    if (const auto unit = unitNamed(kUnitsOfTimes, rest)) return unit;
  }
  return std::nullopt;
}

/// Requires the columns of a group to have the unit of its first one.
template <typename UnitIn>
void requireOneUnit(const CsvTable& table, const std::array<std::size_t, 3>& columns,
                    const UnitIn& unitIn, std::string_view remedy) {
  const std::string& header = table.header()[columns.front()];
  for (const std::size_t column : columns) {
    const std::string& other = table.header()[column];
    if (unitIn(other) == unitIn(header)) continue;
    table.fail("the columns " + quotedText(header) + " and " + quotedText(other) +
               " are in different units; " + std::string(remedy));
  }
}

}  // namespace

bool isGyroscopes(std::string_view header) {
  const std::string name = columnNameOf(header).plain;
  return name.find("gyr") != name.npos || name.find("rotationrate") != name.npos ||
         isAmong("gx gyx", name) || isOfRos(header);
}

bool areSecondsOfRos(std::string_view header) {
  return columnNameOf(header).plain.starts_with("stampsec");
}

bool isTimeNamed(std::string_view plain, std::string_view usual) {
  if (plain == usual) return true;
  if (!plain.starts_with(usual)) return false;
  plain.remove_prefix(usual.size());
  if (unitNamed(kUnitsOfTimes, plain)) return true;
  return plain.starts_with("in") && unitNamed(kUnitsOfTimes, plain.substr(2));
}

void findTimeUnit(const CsvTable& table, Columns& columns, std::string_view stated) {
  const std::string& header = table.header()[columns.time];
  const ColumnName name = columnNameOf(header);
  const Program* const program = programOf(table, columns);
  std::optional<double> unit =
      unitNamed(kUnitsOfTimes, stated.empty() ? std::string_view(name.unit) : stated);
  if (!unit && !name.unit.empty()) {
    table.fail(
        "the column " + quotedText(header) +
        " has times in a unit that isn't read; there are s, ms, us, ns and min: write them in one, "
        "or, if they are, state it in simulation.time_unit, or with --time-unit");
  }
  if (!unit) unit = timeUnitIn(name);
  if (!unit && program != nullptr) unit = program->seconds;
  columns.isTimeUnitStated = unit.has_value();
  columns.secondsPerUnit = unit.value_or(1);
}

std::string_view plausibleUnit(double interval, double last) {
  constexpr double kFirstEpoch = 1e9, kLastEpoch = 4e9;  // of the years 2001 to 2096 [s]
  for (std::size_t i = 1; i < kTimeUnits.size(); ++i) {
    const double epoch = last * kUnitsOfTimes[i].value;
    if (kUnitsOfTimes[i].value < 1 && epoch >= kFirstEpoch && epoch <= kLastEpoch)
      return kTimeUnits[i];
  }
  constexpr double kShortest = 1e-6, kLongest = 0.2;  // [s]
  for (std::size_t i = 1; i < kTimeUnits.size(); ++i) {
    const double seconds = interval * kUnitsOfTimes[i].value;
    if (seconds >= kShortest && seconds <= kLongest) return kTimeUnits[i];
  }
  return "";
}

std::optional<double> rateUnitIn(std::string_view header) {
  const ColumnName name = columnNameOf(header);
  if (!name.unit.empty()) return unitNamed(kUnitsOfRates, name.unit);
  if (isOfRos(header)) return 1;
  const std::string text = lowerCase(header);
  const auto has = [&](std::string_view part) { return text.find(part) != text.npos; };
  if (has("mdeg") || has("mdps") || has("millideg")) return kDegree / 1000;
  if (has("deg") || has("\xC2\xB0") || has("dps")) return kDegree;  // a degree sign
  return has("rad") ? std::optional(1.0) : std::nullopt;            // "radps", too
}

double radiansPerUnit(const CsvTable& table, const Columns& columns, std::string_view stated) {
  if (!stated.empty()) return unitNamed(kUnitsOfRates, stated).value();
  const std::string& header = table.header()[columns.rates->front()];
  requireOneUnit(table, *columns.rates, rateUnitIn,
                 "state one for all in simulation.rates, or with --rates");
  if (const auto unit = rateUnitIn(header)) return *unit;
  const bool isSilent = columnNameOf(header).unit.empty();
  const Program* const program = programOf(table, columns);
  if (isSilent && program != nullptr) return program->rates;
  // Tables of programs, this one's among them, have SI units.
  const bool areAlone = !columns.quaternion && !columns.matrix;
  if (isSilent && !areAlone && !isGyroscopes(header)) return 1;
  if (!isSilent) {
    table.fail("the column " + quotedText(header) +
               " has rates in a unit that isn't read; write them in rad/s or deg/s, or, if they "
               "are, state it in simulation.rates, or with --rates");
  }
  table.fail("the column " + quotedText(header) +
             " doesn't say whether it is in rad/s or deg/s; state it in simulation.rates, or "
             "with --rates");
}

std::optional<double> accelerationUnitIn(std::string_view header) {
  const ColumnName name = columnNameOf(header);
  if (!name.unit.empty()) return unitNamed(kUnitsOfAccelerations, name.unit);
  // Physics Toolbox's gFx
  if (name.plain.starts_with("gf")) return kGravity;
  if (name.words.size() < 2) return std::nullopt;
  return unitNamed(kUnitsOfAccelerations, name.words.back());
}

double metresPerUnit(const CsvTable& table, const Columns& columns) {
  const std::string& header = table.header()[columns.acceleration->front()];
  const std::optional<double> unit = accelerationUnitIn(header);
  if (!unit && !columnNameOf(header).unit.empty()) {
    table.fail("the column " + quotedText(header) +
               " has accelerations in a unit that isn't read; there are m/s^2, cm/s^2, g and mg: "
               "write one in brackets in the header");
  }
  requireOneUnit(table, *columns.acceleration, accelerationUnitIn,
                 "write one for all in the header");
  return unit.value_or(1);
}

}  // namespace rotatebook::recording
