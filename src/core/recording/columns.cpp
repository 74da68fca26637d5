#include "recording/columns.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/nearest_name.h"
#include "base/text.h"

namespace rotatebook::recording {
namespace {

/// A group of columns, and the beginnings of their usual names.
struct Group {
  std::string_view roles;  // separated by blanks
  std::string_view usual;  // of the names, without what tells its columns apart
};

// Names are compared in small letters, without blanks, underscores and what is in brackets.
constexpr Group kTime{"time", "time t times ts timestamp timems timens timeus elapsedtime seconds"};
constexpr Group kQuaternion{"qw qx qy qz",
                            "q quat quaternion motionquaternion orientation attitude "};
constexpr Group kMatrix{"r11 r12 r13 r21 r22 r23 r31 r32 r33", "r m rot matrix"};
constexpr Group kRates{
    "wx wy wz",
    "w g gyr gyro gyroscope gyrorotation omega angularvelocity angvel rate rotationrate "
    "motionrotationrate angularrate"};
constexpr Group kAcceleration{
    "ax ay az", "a acc accel acceleration accelerometer accelerationwithg specificforce"};

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    if (end == text.size()) return words;
    text.remove_prefix(end + 1);
  }
}

char small(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

/// Returns "gyroscopex" for "Gyroscope x (rad/s)".
std::string plain(std::string_view name) {
  std::string text;
  for (const char letter : name.substr(0, name.find_first_of("([{"))) {
    if (letter != ' ' && letter != '_' && letter != '-' && letter != '.') text += small(letter);
  }
  return text;
}

std::string smallText(std::string_view text) {
  std::string result(text);
  for (char& letter : result) letter = small(letter);
  return result;
}

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != text.npos;
}

/// Finds columns in a table's header.
class Finder {
 public:
  Finder(const CsvTable& table, const ColumnNames& named) : table_(table), named_(named) {
    for (const std::string& name : table.header()) plain_.push_back(plain(name));
  }

  /// Returns the columns of a group; none if the table has none of them.
  template <std::size_t N>
  std::optional<std::array<std::size_t, N>> group(const Group& group) const {
    std::array<std::size_t, N> columns{};
    std::vector<std::string> missing;
    const std::vector<std::string_view> roles = wordsOf(group.roles);
    for (std::size_t i = 0; i < N; ++i) {
      const auto column = columnOf(roles[i], group.usual);
      if (column) columns[i] = *column;
      if (!column) missing.emplace_back(roles[i]);
    }
    if (missing.empty()) return columns;
    if (missing.size() == N) return std::nullopt;
    table_.fail("no column for " + listed(missing) + " among " + names() +
                "; name it in simulation.columns, or with --column");
  }

  /// Returns the names of all columns, for messages.
  std::string names() const {
    constexpr std::size_t kShown = 12;
    constexpr std::size_t kLongest = 40;  // [characters]
    std::vector<std::string> shown;
    for (const std::string& name : table_.header()) {
      if (shown.size() == kShown) break;
      shown.push_back(quotedText(oneLine(name, kLongest)));
    }
    if (table_.header().size() > kShown) {
      shown.push_back(std::to_string(table_.header().size() - kShown) + " more");
    }
    return listed(shown);
  }

 private:
  std::optional<std::size_t> columnOf(std::string_view role, std::string_view usual) const {
    const auto stated = std::ranges::find_if(
        named_, [role](const auto& one) { return std::string_view(one.first) == role; });
    if (stated != named_.end()) return indexOf(role, stated->second);
    if (role == kTime.roles) return indexOfUsual(usual, "");
    // The part of the name that tells the columns of a group apart: "x", or "12".
    return indexOfUsual(usual, role.substr(1));
  }

  std::size_t indexOf(std::string_view role, const std::string& name) const {
    const auto& header = table_.header();
    const auto found = std::ranges::find(header, name);
    if (found != header.end()) return static_cast<std::size_t>(found - header.begin());
    table_.fail("no column " + quotedText(name) + ", which is stated for " + std::string(role) +
                ", among " + names());
  }

  std::optional<std::size_t> indexOfUsual(std::string_view usual, std::string_view end) const {
    for (const std::string_view begin : wordsOf(usual)) {
      const std::string wanted = std::string(begin) + std::string(end);
      if (wanted.empty()) continue;
      // A single letter for a quaternion's part is recognised beside the three others alone.
      if (begin.empty() && std::ranges::find(plain_, "w") == plain_.end()) continue;
      const auto found = std::ranges::find(plain_, wanted);
      if (found != plain_.end()) return static_cast<std::size_t>(found - plain_.begin());
    }
    return std::nullopt;
  }

  const CsvTable& table_;
  const ColumnNames& named_;
  std::vector<std::string> plain_;
};

/// Returns the unit in a header's brackets, in small letters without blanks; empty without them.
std::string unitInBrackets(std::string_view header) {
  const std::size_t begin = header.find_first_of("([{");
  if (begin == header.npos) return "";
  const std::string_view inside = header.substr(begin + 1);
  std::string unit = smallText(inside.substr(0, inside.find_first_of(")]}")));
  std::erase(unit, ' ');
  return unit;
}

/// A unit, and names of it, separated by blanks.
template <typename Value>
struct Unit {
  Value value;
  std::string_view names;
};

constexpr Unit<double> kUnitsOfTimes[]{{1, "s sec second seconds"},
                                       {1e-3, "ms millisecond milliseconds"},
                                       {1e-6, "us \xC2\xB5s \xCE\xBCs microsecond microseconds"},
                                       {1e-9, "ns nanosecond nanoseconds"}};
constexpr Unit<std::string_view> kUnitsOfRates[]{
    {kRateUnits[0], "rad/s rads rad/sec radians/s radian/s rads/s rads^-1 rad*s^-1 rad"},
    {kRateUnits[1],
     "deg/s dps deg/sec degrees/s degree/s degs/s degs^-1 deg*s^-1 \xC2\xB0/s \xC2\xB0/sec deg"}};

/// Returns the unit of that name; nothing if it isn't one.
template <typename Units>
auto unitNamed(const Units& units, std::string_view name) {
  const auto found = std::ranges::find_if(units, [&](const auto& unit) {
    const auto names = wordsOf(unit.names);
    return std::ranges::find(names, name) != names.end();
  });
  return found != std::end(units) ? std::optional(found->value) : std::nullopt;
}

/// Returns the unit of the times, in seconds: `stated`, or if that is empty the header's.
double secondsIn(const CsvTable& table, const std::string& header, std::string_view stated) {
  if (!stated.empty()) return unitNamed(kUnitsOfTimes, stated).value();
  const std::string text = smallText(header), unit = unitInBrackets(header);
  if (const auto seconds = unitNamed(kUnitsOfTimes, unit)) return *seconds;
  if (!unit.empty()) {
    table.fail("the column " + quotedText(header) +
               " has times in a unit that isn't read; there are s, ms, us and ns: state one in "
               "simulation.time_unit, or with --time-unit");
  }
  if (text.ends_with("_ms")) return 1e-3;
  if (text.ends_with("_us")) return 1e-6;
  return text.ends_with("_ns") ? 1e-9 : 1;
}

/// Returns the one of kRateUnits that a header states; empty if it states none that is known.
std::string_view unitIn(std::string_view header) {
  const std::string text = smallText(header), unit = unitInBrackets(header);
  if (!unit.empty()) return unitNamed(kUnitsOfRates, unit).value_or("");
  for (const char* degrees : {"deg", "dps", "\xC2\xB0"}) {  // the last is a degree sign
    if (has(text, degrees)) return kRateUnits[1];
  }
  return has(text, "rad") ? kRateUnits[0] : "";
}

/// Returns whether a column is called as a gyroscope's, which measures along the body's axes.
bool isGyroscopes(std::string_view header) {
  const std::string name = plain(header);
  return has(name, "gyr") || has(name, "rotationrate") || name == "gx";
}

/// Returns whether the rates are along the body's axes, by the options or the columns' name.
bool areAlongBody(const CsvTable& table, const Columns& columns, std::string_view stated) {
  const bool areAlone = !columns.quaternion && !columns.matrix;
  if (areAlone && stated == kRateAxes[0]) {
    table.fail("rates alone along the world's axes aren't read; give attitudes beside them");
  }
  if (areAlone || !stated.empty()) return stated != kRateAxes[0];
  return isGyroscopes(table.header()[columns.rates->front()]);
}

double radiansPerUnit(const CsvTable& table, const Columns& columns, std::string_view unit) {
  const std::string& header = table.header()[columns.rates->front()];
  const bool isStated = !unit.empty();
  if (!isStated) unit = unitIn(header);
  for (const std::size_t column : *columns.rates) {
    const std::string& other = table.header()[column];
    if (isStated || unitIn(other) == unit) continue;
    table.fail("the columns " + quotedText(header) + " and " + quotedText(other) +
               " are in different units; state one for all in simulation.rates, or with --rates");
  }
  // Tables of programs, this one's among them, have SI units.
  const bool areAlone = !columns.quaternion && !columns.matrix;
  const bool arePrograms = !areAlone && !isGyroscopes(header);
  if (unit.empty() && arePrograms && unitInBrackets(header).empty()) return 1;
  if (unit.empty()) {
    table.fail("the column " + quotedText(header) +
               " doesn't say whether it is in rad/s or deg/s; state it in simulation.rates, or "
               "with --rates");
  }
  return unit == kRateUnits[1] ? std::numbers::pi / 180 : 1;
}

}  // namespace

std::vector<std::string_view> columnRoles() {
  std::vector<std::string_view> roles;
  for (const Group& group : {kTime, kQuaternion, kMatrix, kRates, kAcceleration}) {
    for (const std::string_view role : wordsOf(group.roles)) roles.push_back(role);
  }
  return roles;
}

Columns findColumns(const CsvTable& table, const ReadOptions& options) {
  const Finder finder(table, options.columns);
  Columns columns;
  const auto time = finder.group<1>(kTime);
  if (!time) {
    table.fail("no column of times among " + finder.names() +
               "; name it in simulation.columns, or with --column");
  }
  columns.time = time->front();
  columns.secondsPerUnit = secondsIn(table, table.header()[columns.time], options.timeUnit);
  columns.quaternion = finder.group<4>(kQuaternion);
  if (!columns.quaternion) columns.matrix = finder.group<9>(kMatrix);
  columns.rates = finder.group<3>(kRates);
  columns.acceleration = finder.group<3>(kAcceleration);
  if (!columns.quaternion && !columns.matrix && !columns.rates) {
    table.fail("neither attitudes (qw to qz, or r11 to r33) nor rates (wx to wz) among " +
               finder.names() + "; name them in simulation.columns, or with --column");
  }
  if (!columns.rates) return columns;
  columns.areRatesAlongBody = areAlongBody(table, columns, options.ratesAlong);
  columns.radiansPerUnit = radiansPerUnit(table, columns, options.unit);
  return columns;
}

}  // namespace rotatebook::recording
