#include "recording/columns.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "recording/column_name.h"
#include "recording/column_units.h"

namespace rotatebook::recording {
namespace {

/// A group of columns, and the beginnings of their usual names.
struct Group {
  std::string_view roles;  // separated by blanks
  std::string_view usual;  // of the names, without what tells its columns apart
};

// Names are compared in small letters, without blanks, underscores and what is in brackets.
constexpr Group kTime{"time", kTimeNames};
constexpr Group kQuaternion{"qw qx qy qz",
                            "q quat quaternion motionquaternion orientation attitude qrs "};
constexpr Group kMatrix{"r11 r12 r13 r21 r22 r23 r31 r32 r33", "r m rot matrix"};
constexpr Group kRates{
    "wx wy wz",
    "w g gyr gyro gyroscope gyrorotation omega angularvelocity angvel rate rotationrate "
    "motionrotationrate angularrate wrss gyroskop giroscopio gyroscoop"};
// Physics Toolbox's gFx is the specific force beside ax without gravity.
constexpr Group kAcceleration{
    "ax ay az",
    "gf a acc accel acceleration accelerometer accelerationwithg specificforce arss "
    "beschleunigung acc\xC3\xA9l\xC3\xA9ration aceleraci\xC3\xB3n accelerazione versnelling"};

/// Finds columns in a table's header.
class Finder {
 public:
  Finder(const CsvTable& table, const ColumnNames& named) : table_(table), named_(named) {
    for (const std::string& name : table.header()) plain_.push_back(columnNameOf(name).plain);
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

  /// Returns the columns called x, y and z alone; none if there aren't all three, or if they are a
  /// quaternion's.
  std::optional<std::array<std::size_t, 3>> bareAxes() const {
    if (hasPlain("w")) return std::nullopt;
    std::array<std::size_t, 3> columns{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::string axis(1, static_cast<char>('x' + i));
      const auto column = onlyOne([&](std::size_t k) {
        return plain_[k] == axis || plain_[k] == axis + "axis" || plain_[k] == "axis" + axis;
      });
      if (!column) return std::nullopt;
      columns[i] = *column;
    }
    return columns;
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
    const auto found = onlyOne([&](std::size_t i) { return table_.header()[i] == name; });
    if (found) return *found;
    table_.fail("no column " + quotedText(name) + ", which is stated for " + std::string(role) +
                ", among " + names());
  }

  std::optional<std::size_t> indexOfUsual(std::string_view usual, std::string_view end) const {
    for (const std::string_view begin : wordsOf(usual)) {
      const std::string wanted = std::string(begin) + std::string(end);
      if (wanted.empty()) continue;
      // A single letter for a quaternion's part is recognised beside the three others alone.
      if (begin.empty() && !hasPlain("w")) continue;
      auto found = onlyOne([&](std::size_t i) { return plain_[i] == wanted; });
      if (!found && end.empty())
        found = onlyOne([&](std::size_t i) { return isTimeNamed(plain_[i], wanted); });
      if (found) return found;
    }
    return std::nullopt;
  }

  bool hasPlain(std::string_view name) const { return std::ranges::count(plain_, name) > 0; }

  /// Returns the column that is wanted; nothing if none is. Throws InputError if several are.
  template <typename IsWanted>
  std::optional<std::size_t> onlyOne(const IsWanted& isWanted) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < plain_.size(); ++i) {
      if (!isWanted(i)) continue;
      if (found) failTwice(*found, i);
      found = i;
    }
    return found;
  }

  [[noreturn]] void failTwice(std::size_t first, std::size_t second) const {
    const std::string &one = table_.header()[first], &other = table_.header()[second];
    const std::string remedy =
        one == other ? "give one of them another name, or put what belongs to it in another table"
                     : "name the one to take in simulation.columns, or with --column";
    table_.fail("the columns " + std::to_string(first + 1) + " and " + std::to_string(second + 1) +
                ", " + quotedText(one) + " and " + quotedText(other) + ", hold the same; " +
                remedy);
  }

  const CsvTable& table_;
  const ColumnNames& named_;
  std::vector<std::string> plain_;
};

/// Returns whether the rates are along the body's axes, by the options or the columns' name.
bool areAlongBody(const CsvTable& table, const Columns& columns, std::string_view stated) {
  const bool areAlone = !columns.quaternion && !columns.matrix;
  if (areAlone && stated == kRateAxes[0]) {
    table.fail("rates alone along the world's axes aren't read; give attitudes beside them");
  }
  if (areAlone || !stated.empty()) return stated != kRateAxes[0];
  return isGyroscopes(table.header()[columns.rates->front()]);
}

/// Returns the small letters of a file's name, without its folders.
std::string fileNameOf(const std::string& path) {
  return smallText(path.substr(path.find_last_of("/\\") + 1));
}

/// Gives columns called x, y and z alone to the sensor that their unit or the file's name says.
void assignBareAxes(const CsvTable& table, const Finder& finder, Columns& columns) {
  if (columns.rates && columns.acceleration) return;
  const auto axes = finder.bareAxes();
  if (!axes) return;
  const std::string &header = table.header()[axes->front()], file = fileNameOf(table.name());
  const auto says = [&](std::string_view part) { return file.find(part) != file.npos; };
  const bool hasUnit = !columnNameOf(header).unit.empty();
  if (!columns.rates && (hasUnit ? !rateUnitIn(header).empty() : says("gyro")))
    columns.rates = axes;
  // Sensor Logger's Accelerometer.csv is without gravity, its TotalAcceleration.csv with it.
  const std::string time = columnNameOf(table.header()[columns.time]).plain;
  const bool isWithGravity = !says("linear") && !says("user") && !says("gravity") &&
                             (time != "secondselapsed" || says("total"));
  const bool isForce = hasUnit ? accelerationUnitIn(header).has_value() : says("accel");
  if (!columns.rates && !columns.acceleration && isForce && isWithGravity)
    columns.acceleration = axes;
}

}  // namespace

std::vector<std::string_view> columnRoles() {
  std::vector<std::string_view> roles;
  for (const Group& group : {kTime, kQuaternion, kMatrix, kRates, kAcceleration}) {
    for (const std::string_view role : wordsOf(group.roles)) roles.push_back(role);
  }
  return roles;
}

Columns columnsIn(const CsvTable& table, const ReadOptions& options) {
  const Finder finder(table, options.columns);
  Columns columns;
  const auto time = finder.group<1>(kTime);
  if (!time) {
    table.fail("no column of times among " + finder.names() +
               "; name it in simulation.columns, or with --column");
  }
  columns.time = time->front();
  findTimeUnit(table, columns, options.timeUnit);
  columns.quaternion = finder.group<4>(kQuaternion);
  if (!columns.quaternion) columns.matrix = finder.group<9>(kMatrix);
  columns.rates = finder.group<3>(kRates);
  columns.acceleration = finder.group<3>(kAcceleration);
  assignBareAxes(table, finder, columns);
  return columns;
}

Columns findColumns(const CsvTable& table, const ReadOptions& options) {
  Columns columns = columnsIn(table, options);
  if (!columns.quaternion && !columns.matrix && !columns.rates) {
    table.fail("neither attitudes (qw to qz, or r11 to r33) nor rates (wx to wz) among " +
               Finder(table, options.columns).names() +
               "; name them in simulation.columns, or with --column");
  }
  if (!columns.rates) return columns;
  columns.areRatesAlongBody = areAlongBody(table, columns, options.ratesAlong);
  columns.radiansPerUnit = radiansPerUnit(table, columns, options.unit);
  return columns;
}

}  // namespace rotatebook::recording
