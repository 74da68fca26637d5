#include "recording/columns.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "recording/column_finder.h"
#include "recording/column_name.h"
#include "recording/column_spellings.h"
#include "recording/column_units.h"
#include "recording/words.h"

namespace rotatebook::recording {
namespace {

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
  return lowerCase(path.substr(path.find_last_of("/\\:") + 1));
}

/// Gives columns called x, y and z alone to the sensor that their unit or the file's name says.
void assignBareAxes(const CsvTable& table, const ColumnFinder& finder, Columns& columns) {
  if (columns.rates && columns.acceleration) return;
  const auto axes = finder.bareAxes();
  if (!axes) return;
  const std::string &header = table.header()[axes->front()], file = fileNameOf(table.name());
  const auto says = [&](std::string_view part) { return file.find(part) != file.npos; };
  const bool hasUnit = !columnNameOf(header).unit.empty();
  if (!columns.rates &&
      (hasUnit ? rateUnitIn(header).has_value() : says("gyro") || says("angularvel")))
    columns.rates = axes;
  // Sensor Logger's Accelerometer.csv is without gravity, its TotalAcceleration.csv with it.
  const std::string time = columnNameOf(table.header()[columns.time]).plain;
  const bool isWithGravity = !says("linear") && !says("user") && !says("gravity") &&
                             (time != "secondselapsed" || says("total"));
  const bool isForce = hasUnit ? accelerationUnitIn(header).has_value() : says("accel");
  if (!columns.rates && !columns.acceleration && isForce && isWithGravity)
    columns.acceleration = axes;
}

/// Refuses attitudes in two forms, of which the options name none, or leaves one.
void takeOneForm(const ColumnFinder& finder, Columns& columns) {
  if (!columns.quaternion || !columns.matrix) return;
  if (finder.isNamed(kQuaternions) == finder.isNamed(kMatrices))
    finder.failTwice(columns.quaternion->front(), columns.matrix->front());
  if (finder.isNamed(kMatrices)) columns.quaternion.reset();
  if (finder.isNamed(kQuaternions)) columns.matrix.reset();
}

/// Leaves out quaternions of zeros, as ROS's drivers write them that don't know the attitude.
void dropZeros(const CsvTable& table, Columns& columns) {
  if (!columns.quaternion || !columns.rates) return;
  const auto isZero = [&](std::size_t column) {
    return !table.isHole(0, column) && !table.isText(0, column) && table.at(0, column) == 0;
  };
  if (std::ranges::all_of(*columns.quaternion, isZero)) columns.quaternion.reset();
}

}  // namespace

std::vector<std::string_view> columnRoles() {
  std::vector<std::string_view> roles{"time"};
  for (const Spellings& group : {kQuaternions, kMatrices, kRates, kAccelerations}) {
    for (const std::string_view role : wordsOf(group.roles)) roles.push_back(role);
  }
  return roles;
}

Columns columnsIn(const CsvTable& table, const ReadOptions& options) {
  const ColumnFinder finder(table, options.columns);
  Columns columns;
  const auto time = finder.time();
  if (!time) {
    table.fail("no column of times among " + finder.names() +
               "; name it in simulation.columns, or with --column");
  }
  columns.time = *time;
  if (areSecondsOfRos(table.header()[*time])) columns.nanoseconds = finder.nanoseconds();
  findTimeUnit(table, columns, options.timeUnit);
  columns.quaternion = finder.group<4>(kQuaternions);
  columns.matrix = finder.group<9>(kMatrices);
  takeOneForm(finder, columns);
  columns.rates = finder.group<3>(kRates);
  columns.acceleration = finder.group<3>(kAccelerations);
  dropZeros(table, columns);
  assignBareAxes(table, finder, columns);
  return columns;
}

Columns findColumns(const CsvTable& table, const ReadOptions& options) {
  Columns columns = columnsIn(table, options);
  if (!columns.quaternion && !columns.matrix && !columns.rates) {
    table.fail("neither attitudes (qw to qz, or r11 to r33) nor rates (wx to wz) among " +
               ColumnFinder(table, options.columns).names() +
               "; name them in simulation.columns, or with --column");
  }
  if (!columns.rates) return columns;
  columns.areRatesAlongBody = areAlongBody(table, columns, options.ratesAlong);
  columns.radiansPerUnit = radiansPerUnit(table, columns, options.unit);
  return columns;
}

}  // namespace rotatebook::recording
