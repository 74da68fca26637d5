#include "recording/column_units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <string>

#include "base/text.h"
#include "recording/column_name.h"

namespace rotatebook::recording {
namespace {

/// A unit, and names of it, separated by blanks.
template <typename Value>
struct Unit {
  Value value;
  std::string_view names;
};

constexpr Unit<double> kUnitsOfTimes[]{
    {1, "s sec secs second seconds"},
    {1e-3, "ms msec msecs milli millis millisecond milliseconds"},
    {1e-6, "us usec usecs micro micros \xC2\xB5s \xCE\xBCs microsecond microseconds"},
    {1e-9, "ns nsec nsecs nano nanos nanosecond nanoseconds"}};
// The last names are those with a dot and superscripts.
constexpr Unit<std::string_view> kUnitsOfRates[]{
    {kRateUnits[0],
     "rad/s rads rad/sec radians/s radians/sec radian/s radian/sec rads/s rads^-1 rads-1 rad*s^-1 "
     "rad.s^-1 rad.s-1 radps rad rads\xE2\x81\xBB\xC2\xB9 rad\xC2\xB7s\xE2\x81\xBB\xC2\xB9 "
     "rad\xC2\xB7s^-1"},
    {kRateUnits[1],
     "deg/s dps deg/sec degrees/s degrees/sec degree/s degree/sec degs/s degs^-1 degs-1 deg*s^-1 "
     "deg.s^-1 degps \xC2\xB0/s \xC2\xB0/sec deg \xC2\xB0s\xE2\x81\xBB\xC2\xB9 \xC2\xB0s-1"}};
constexpr double kGravity = 9.80665;  // [m/s^2]
constexpr Unit<double> kUnitsOfAccelerations[]{
    {1,
     "m/s^2 m/s2 m/s/s m/s**2 m/sec^2 m/sec2 ms^-2 ms-2 m*s^-2 m.s^-2 mps2 ms2 mss m/s\xC2\xB2 "
     "ms\xE2\x81\xBB\xC2\xB2 m\xC2\xB7s\xE2\x81\xBB\xC2\xB2"},
    {0.01, "cm/s^2 cm/s2 cm/s\xC2\xB2"},
    {kGravity, "g gs g's gn gee"},
    {kGravity / 1000, "mg mgs milli-g millig"}};

/// Programs that write no units: by the name of the time, the units of times and rates.
struct Program {
  std::string_view time;
  double seconds;
  std::string_view rates;
};
constexpr Program kPrograms[]{{"secondselapsed", 1, kRateUnits[0]},      // Sensor Logger
                              {"sampletimefine", 1e-6, kRateUnits[1]}};  // Xsens DOT

const Program* programOf(const CsvTable& table, const Columns& columns) {
  const std::string name = columnNameOf(table.header()[columns.time]).plain;
  const auto found = std::ranges::find_if(
      kPrograms, [&](const Program& program) { return isTimeNamed(name, program.time); });
  return found != std::end(kPrograms) ? found : nullptr;
}

/// Returns the unit of that name; nothing if it isn't one.
template <typename Units>
auto unitNamed(const Units& units, std::string_view name) {
  const auto found =
      std::ranges::find_if(units, [&](const auto& unit) { return isAmong(unit.names, name); });
  return found != std::end(units) ? std::optional(found->value) : std::nullopt;
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
  return name.find("gyr") != name.npos || name.find("rotationrate") != name.npos || name == "gx";
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
    table.fail("the column " + quotedText(header) +
               " has times in a unit that isn't read; there are s, ms, us and ns: state one in "
               "simulation.time_unit, or with --time-unit");
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
    if (epoch >= kFirstEpoch && epoch <= kLastEpoch) return kTimeUnits[i];
  }
  constexpr double kShortest = 1e-6, kLongest = 0.2;  // [s]
  for (std::size_t i = 1; i < kTimeUnits.size(); ++i) {
    const double seconds = interval * kUnitsOfTimes[i].value;
    if (seconds >= kShortest && seconds <= kLongest) return kTimeUnits[i];
  }
  return "";
}

std::string_view rateUnitIn(std::string_view header) {
  const std::string unit = columnNameOf(header).unit, text = smallText(header);
  if (!unit.empty()) return unitNamed(kUnitsOfRates, unit).value_or("");
  const auto has = [&](std::string_view part) { return text.find(part) != text.npos; };
  if (has("mdeg") || has("mdps") || has("millideg")) return "";  // thousandths are refused
  if (has("deg") || has("\xC2\xB0")) return kRateUnits[1];       // a degree sign
  if (has("rad")) return kRateUnits[0];                          // "radps", too
  return has("dps") ? kRateUnits[1] : "";
}

double radiansPerUnit(const CsvTable& table, const Columns& columns, std::string_view stated) {
  const std::string& header = table.header()[columns.rates->front()];
  std::string_view unit = stated;
  if (stated.empty()) {
    requireOneUnit(table, *columns.rates, rateUnitIn,
                   "state one for all in simulation.rates, or with --rates");
    unit = rateUnitIn(header);
  }
  const bool isSilent = unit.empty() && columnNameOf(header).unit.empty();
  const Program* const program = programOf(table, columns);
  if (isSilent && program != nullptr) unit = program->rates;
  // Tables of programs, this one's among them, have SI units.
  const bool areAlone = !columns.quaternion && !columns.matrix;
  if (isSilent && unit.empty() && !areAlone && !isGyroscopes(header)) return 1;
  if (unit.empty()) {
    table.fail("the column " + quotedText(header) +
               " doesn't say whether it is in rad/s or deg/s; state it in simulation.rates, or "
               "with --rates");
  }
  return unit == kRateUnits[1] ? std::numbers::pi / 180 : 1;
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
