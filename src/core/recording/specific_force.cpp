#include "recording/specific_force.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "recording/column_units.h"
#include "recording/columns.h"
#include "recording/sensor_rows.h"

namespace rotatebook::recording {
namespace {

/// Refuses accelerations without a unit that are at rest what those in g or mg are.
void requireSeeminglyMetres(const CsvTable& table, const Columns& columns,
                            const std::vector<Force>& forces) {
  const std::string& header = table.header()[columns.acceleration->front()];
  if (accelerationUnitIn(header)) return;
  std::vector<double> sizes;
  for (const Force& one : forces) sizes.push_back(one.force.norm());
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  constexpr double kLow = 0.8, kHigh = 1.25;  // of a body at rest [g]
  for (const auto& [unit, size] : {std::pair{"g", 1.0}, std::pair{"mg", 1000.0}}) {
    if (*middle < kLow * size || *middle > kHigh * size) continue;
    table.fail("the column " + quotedText(header) + " doesn't state its unit, and seems to be in " +
               unit + ": its usual size is " + roundedText(*middle, 3) + "; write (" + unit +
               ") or (m/s^2) in the header");
  }
}

}  // namespace

std::vector<Force> forcesOf(const CsvTable& table, const Columns& columns,
                            const std::vector<std::size_t>& rows, double zero) {
  const double unit = metresPerUnit(table, columns);
  const std::vector<double> times = timesOf(table, columns, rows, zero);
  constexpr double kLargestForce = 1e9;  // [m/s^2]
  std::vector<Force> forces;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Force one{times[i]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      one.force[static_cast<Eigen::Index>(axis)] =
          unit * table.at(rows[i], (*columns.acceleration)[axis]);
    }
    if (!(one.force.norm() <= kLargestForce))
      table.failAt(rows[i], "the acceleration is over 1e9 m/s^2");
    forces.push_back(one);
  }
  requireSeeminglyMetres(table, columns, forces);
  return forces;
}

std::vector<Force> forcesIn(const NamedTable& named, const ReadOptions& options, double zero) {
  const CsvTable table(named.bytes, named.name);
  Columns columns = columnsIn(table, withoutMissing(options, table));
  if (!columns.acceleration) {
    table.fail(
        "no accelerometer's columns (ax to az) with gravity, as phyphox's Accelerometer.csv and "
        "Sensor Logger's TotalAcceleration.csv have them; name others with --column");
  }
  columns.rates.reset();
  columns.quaternion.reset();
  columns.matrix.reset();
  return forcesOf(table, columns, sensorRows(table, columns, true).force, zero);
}

void addForces(InertialRecording& recording, const std::vector<Force>& forces,
               const std::string& name) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  std::size_t next = 0;
  bool isAnyKnown = false;
  for (InertialReading& reading : recording.readings) {
    const double time = reading.rate.time;
    while (next < forces.size() && forces[next].time < time) ++next;
    const bool isWithin = next < forces.size() && (next > 0 || forces[next].time == time);
    reading.force = Eigen::Vector3d(kUnknown, 0, 0);
    if (!isWithin) continue;
    isAnyKnown = true;
    const Force& after = forces[next];
    reading.force = after.force;
    if (after.time == time) continue;
    const Force& before = forces[next - 1];
    const double part = (time - before.time) / (after.time - before.time);
    reading.force = before.force + part * (after.force - before.force);
  }
  if (isAnyKnown) return;
  const auto text = [&](double time) { return shortestText(recording.zero + time); };
  throw InputError(name + ": its times, from " + text(forces.front().time) + " to " +
                   text(forces.back().time) + " s, have none of the gyroscope's, from " +
                   text(recording.readings.front().rate.time) + " to " +
                   text(recording.readings.back().rate.time) +
                   " s; take both tables from one recording");
}

ReadOptions withoutMissing(ReadOptions options, const CsvTable& table) {
  std::erase_if(options.columns, [&](const auto& one) {
    return std::ranges::count(table.header(), one.second) == 0;
  });
  return options;
}

ReadOptions withoutForce(ReadOptions options) {
  std::erase_if(options.columns, [](const auto& one) { return one.first.starts_with('a'); });
  return options;
}

}  // namespace rotatebook::recording
