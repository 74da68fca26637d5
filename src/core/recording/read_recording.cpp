#include "recording/read_recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "recording/columns.h"
#include "recording/conventions.h"
#include "recording/csv_table.h"
#include "rigid/rotation.h"

namespace rotatebook::recording {
namespace {

constexpr double kLargestRate = 1e9;   // [rad/s], as in scenes
constexpr double kLargestTime = 1e12;  // [s]
// Deviation of a quaternion's norm from 1, or of a matrix from a rotation, of what is rounded to
// two decimals.
constexpr double kNoRotation = 0.01;

Eigen::Vector3d vectorAt(const CsvTable& table, std::size_t row,
                         const std::array<std::size_t, 3>& columns) {
  return {table.at(row, columns[0]), table.at(row, columns[1]), table.at(row, columns[2])};
}

Eigen::Vector3d rateAt(const CsvTable& table, std::size_t row, const Columns& columns) {
  const Eigen::Vector3d rate = columns.radiansPerUnit * vectorAt(table, row, *columns.rates);
  if (!(rate.norm() <= kLargestRate)) table.failAt(row, "the rate is over 1e9 rad/s");
  return rate;
}

Eigen::Quaterniond quaternionAt(const CsvTable& table, std::size_t row,
                                const std::array<std::size_t, 4>& columns) {
  const Eigen::Quaterniond q(table.at(row, columns[0]), table.at(row, columns[1]),
                             table.at(row, columns[2]), table.at(row, columns[3]));
  const double norm = q.norm();
  if (std::abs(norm - 1) <= kNoRotation) return q.normalized();
  table.failAt(row, "the quaternion's norm is " + roundedText(norm, 4) + ", not 1");
}

Eigen::Quaterniond matrixAt(const CsvTable& table, std::size_t row,
                            const std::array<std::size_t, 9>& columns) {
  Eigen::Matrix3d matrix;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    matrix(index / 3, index % 3) = table.at(row, columns[i]);
  }
  const Eigen::Matrix3d square = matrix * matrix.transpose() - Eigen::Matrix3d::Identity();
  if (square.cwiseAbs().maxCoeff() <= 2 * kNoRotation && matrix.determinant() > 0) {
    return Eigen::Quaterniond(rigid::polarFactor(matrix)).normalized();
  }
  table.failAt(row, "r11 to r33 are no rotation");
}

Eigen::Quaterniond attitudeAt(const CsvTable& table, std::size_t row, const Columns& columns) {
  return columns.quaternion ? quaternionAt(table, row, *columns.quaternion)
                            : matrixAt(table, row, *columns.matrix);
}

/// Returns the times of all rows. [s]
std::vector<double> timesOf(const CsvTable& table, const Columns& columns) {
  std::vector<double> times;
  times.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double time = columns.secondsPerUnit * table.at(row, columns.time);
    if (!(std::abs(time) <= kLargestTime)) table.failAt(row, "the time is beyond 1e12 s");
    // Beyond rounding, so that slopes between neighbours are finite.
    const double gap = times.empty() ? 1 : time - times.back();
    if (!(gap > 1e-12 * std::abs(time) && gap > 1e-9)) {
      table.failAt(row, "the time " + shortestText(time) + " s isn't after that of the row before");
    }
    times.push_back(time);
  }
  if (times.size() < 2) table.fail("a single row; a motion takes at least two");
  return times;
}

/// Refuses a turn since the row before that no reading could have followed.
void requireFollowed(const CsvTable& table, std::size_t row, const std::vector<Rate>& rates) {
  constexpr double kLargestTurn = 1000;  // [rad]
  const Rate &before = rates[row - 1], &here = rates[row];
  const double fastest = std::max(before.angularVelocity.norm(), here.angularVelocity.norm());
  if (fastest * (here.time - before.time) <= kLargestTurn) return;
  table.failAt(row,
               "the body turns by more than 1000 rad since the row before; is the unit of the "
               "time or of the rates another?");
}

std::vector<RecordedMoment> integratedRates(const CsvTable& table, const Columns& columns,
                                            const Eigen::Vector3d& bias) {
  const std::vector<double> times = timesOf(table, columns);
  std::vector<Rate> rates;
  for (std::size_t row = 0; row < times.size(); ++row) {
    rates.push_back({times[row], rateAt(table, row, columns) - bias});
    if (row > 0) requireFollowed(table, row, rates);
  }
  return integrateRates(rates);
}

/// Returns the attitudes, with the rates beside them if there are any.
std::vector<RecordedMoment> attitudesOf(const CsvTable& table, const Columns& columns,
                                        const Eigen::Vector3d& bias) {
  const std::vector<double> times = timesOf(table, columns);
  std::vector<RecordedMoment> moments;
  for (std::size_t row = 0; row < times.size(); ++row) {
    moments.push_back({times[row], attitudeAt(table, row, columns)});
    if (!columns.rates) continue;
    const Eigen::Vector3d rate = rateAt(table, row, columns);
    moments.back().angularVelocity = columns.areRatesAlongBody
                                         ? (rate - bias).eval()
                                         : moments.back().attitude.conjugate() * rate;
  }
  return moments;
}

void differentiate(const CsvTable& table, std::vector<RecordedMoment>& moments) {
  differentiateAttitudes(moments);
  for (std::size_t row = 0; row < moments.size(); ++row) {
    if (!(moments[row].angularVelocity.norm() <= kLargestRate)) {
      table.failAt(row, "the attitude changes by more than 1e9 rad/s");
    }
  }
}

/// Returns the uncertainty of the slopes, see SpinFacts.
double uncertaintyOf(const std::vector<RecordedMoment>& moments) {
  std::vector<RecordedMoment> others = moments;
  differentiateAttitudes(others, 1);
  double difference = 0, all = 0;
  for (std::size_t i = 2; i + 2 < moments.size(); ++i) {
    difference += (others[i].angularVelocity - moments[i].angularVelocity).squaredNorm();
    all += moments[i].angularVelocity.squaredNorm();
  }
  return all > 0 ? std::sqrt(difference / all) : 0;
}

/// Returns the moments of the stated part.
std::vector<RecordedMoment> within(std::vector<RecordedMoment> moments,
                                   const ReadOptions& options) {
  std::erase_if(moments, [&](const RecordedMoment& one) {
    return (options.from && one.time < *options.from) || (options.to && one.time > *options.to);
  });
  return moments;
}

/// Returns by how much the rates differ from the attitudes' slopes. Throws ContradictionError if
/// they contradict them.
double differenceOf(const std::vector<RecordedMoment>& moments, bool areRatesAlongBody,
                    const std::string& name) {
  const RateComparison found = compareRates(moments, areRatesAlongBody);
  if (!found.mistake.empty()) throw ContradictionError(name + ": " + found.mistake);
  if (!areRatesAlongBody || found.difference <= kContradicts) return found.difference;
  throw ContradictionError(
      name + ": the rates along the body's axes aren't the attitudes' slopes: they differ by " +
      roundedText(100 * found.difference, 2) +
      " %, with no other axes, order or unit by less; are both of the same body and moment?");
}

/// Returns the stated part of a motion whose first moment was at `start` of the file's times. [s]
RecordedMotion partOf(const RecordedMotion& motion, double start, const std::string& name,
                      const ReadOptions& options) {
  if (!options.from && !options.to) return motion;
  const double end = start + motion.duration();
  const double from = options.from.value_or(start), to = options.to.value_or(end);
  if (from >= start && to <= end && from < to) return motion.part(from - start, to - start);
  throw InputError(name + ": the part from " + shortestText(from) + " to " + shortestText(to) +
                   " s isn't within the recording, which lasts from " + shortestText(start) +
                   " to " + shortestText(end) + " s");
}

}  // namespace

RecordedMotion readRecording(std::string_view bytes, const std::string& name,
                             const ReadOptions& options) {
  const CsvTable table(bytes, name);
  const Columns columns = findColumns(table, options);
  const bool hasAttitudes = columns.quaternion || columns.matrix;
  std::vector<RecordedMoment> moments = hasAttitudes
                                            ? attitudesOf(table, columns, options.bias)
                                            : integratedRates(table, columns, options.bias);
  SpinFacts spins{hasAttitudes ? SpinSource::Given : SpinSource::Gyroscope};
  if (hasAttitudes && !columns.rates) {
    differentiate(table, moments);
    spins = {SpinSource::Slopes, uncertaintyOf(within(moments, options))};
  } else if (hasAttitudes) {
    spins.difference = differenceOf(within(moments, options), columns.areRatesAlongBody, name);
  }
  const double start = moments.front().time;
  return partOf(RecordedMotion(std::move(moments), spins), start, name, options);
}

InertialRecording readInertial(std::string_view bytes, const std::string& name,
                               const ReadOptions& options) {
  const CsvTable table(bytes, name);
  const Columns columns = findColumns(table, options);
  if (!columns.rates || columns.quaternion || columns.matrix) {
    table.fail("no gyroscope's rates (wx to wz) alone, along the body's axes");
  }
  const std::vector<double> times = timesOf(table, columns);
  std::vector<Rate> rates;
  InertialRecording recording;
  recording.hasForce = columns.acceleration.has_value();
  for (std::size_t row = 0; row < times.size(); ++row) {
    rates.push_back({times[row], rateAt(table, row, columns)});
    if (row > 0) requireFollowed(table, row, rates);
    InertialReading reading{rates.back()};
    if (recording.hasForce) reading.force = vectorAt(table, row, *columns.acceleration);
    recording.readings.push_back(reading);
  }
  return recording;
}

}  // namespace rotatebook::recording
