#include "recording/read_recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.h"
#include "base/file_text.h"
#include "base/number_text.h"
#include "base/text.h"
#include "recording/attitudes_alone.h"
#include "recording/columns.h"
#include "recording/conventions.h"
#include "recording/csv_table.h"
#include "recording/flawed_rows.h"
#include "recording/gaps.h"
#include "recording/held_readings.h"
#include "recording/sensor_rows.h"
#include "recording/specific_force.h"
#include "rigid/rotation.h"

namespace rotatebook::recording {
namespace {

constexpr double kLargestRate = 1e9;  // [rad/s], as in scenes
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

/// Refuses a turn since the row before that no reading could have followed.
void requireFollowed(const CsvTable& table, std::size_t row, const std::vector<Rate>& rates) {
  constexpr double kLargestTurn = 1000;  // [rad]
  const Rate &before = rates[rates.size() - 2], &here = rates.back();
  const double fastest = std::max(before.angularVelocity.norm(), here.angularVelocity.norm());
  if (fastest * (here.time - before.time) <= kLargestTurn) return;
  table.failAt(row,
               "the body turns by more than 1000 rad since the row before; is the unit of the "
               "time or of the rates another?");
}

std::vector<Rate> ratesOf(const CsvTable& table, const Columns& columns, const SensorRows& rows,
                          const std::vector<double>& times, const Eigen::Vector3d& bias) {
  std::vector<Rate> rates;
  for (std::size_t i = 0; i < times.size(); ++i) {
    rates.push_back({times[i], rateAt(table, rows.motion[i], columns) - bias});
    if (i > 0) requireFollowed(table, rows.motion[i], rates);
  }
  requirePlausibleTurns(table, columns, rates);
  return rates;
}

/// Returns the attitudes, with the rates beside them if there are any.
std::vector<RecordedMoment> attitudesOf(const CsvTable& table, const Columns& columns,
                                        const SensorRows& rows, const std::vector<double>& times,
                                        const Eigen::Vector3d& bias) {
  std::vector<RecordedMoment> moments;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::size_t row = rows.motion[i];
    moments.push_back({times[i], attitudeAt(table, row, columns)});
    if (!columns.rates) continue;
    const Eigen::Vector3d rate = rateAt(table, row, columns);
    moments.back().angularVelocity = columns.areRatesAlongBody
                                         ? (rate - bias).eval()
                                         : moments.back().attitude.conjugate() * rate;
  }
  return moments;
}

void differentiate(const CsvTable& table, const SensorRows& rows,
                   std::vector<RecordedMoment>& moments) {
  differentiateAttitudes(moments);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (!(moments[i].angularVelocity.norm() <= kLargestRate)) {
      table.failAt(rows.motion[i], "the attitude changes by more than 1e9 rad/s");
    }
  }
}

/// Returns the moments of the stated part.
std::vector<RecordedMoment> within(std::vector<RecordedMoment> moments,
                                   const ReadOptions& options) {
  std::erase_if(moments, [&](const RecordedMoment& one) {
    return (options.from && one.time < *options.from) || (options.to && one.time > *options.to);
  });
  return moments;
}

/// Returns the facts of rates beside attitudes. Throws ContradictionError if they contradict them.
SpinFacts factsOf(const std::vector<RecordedMoment>& moments, const Columns& columns,
                  const std::string& name, const std::vector<std::string>& flaws = {}) {
  const RateComparison found = compareRates(
      moments, columns.areRatesAlongBody,
      {columns.secondsPerUnit, columns.radiansPerUnit, columns.quaternion.has_value()});
  if (!found.mistake.empty()) {
    const std::string flaw = flaws.empty() ? "" : joined(flaws, "; ") + "; and without that, ";
    throw ContradictionError(name + ": " + flaw + found.mistake);
  }
  SpinFacts facts;
  facts.difference = found.difference;
  facts.fit = found.fit;
  return facts;
}

bool hasAttitudes(const Columns& columns) {
  return columns.quaternion || columns.matrix;
}

std::vector<Rate> ratesOf(const std::vector<RecordedMoment>& moments) {
  std::vector<Rate> rates;
  for (const RecordedMoment& moment : moments)
    rates.push_back({moment.time, moment.angularVelocity});
  return rates;
}

/// Returns the rates of a table of attitudes: those beside them, or their slopes.
std::vector<Rate> ratesBeside(const CsvTable& table, const Columns& columns, const SensorRows& rows,
                              const std::vector<double>& times, const std::string& name) {
  std::vector<RecordedMoment> moments =
      attitudesOf(table, columns, rows, times, Eigen::Vector3d::Zero());
  if (columns.rates) factsOf(moments, columns, name);
  if (!columns.rates) differentiate(table, rows, moments);
  return ratesOf(moments);
}

/// Returns the part of a motion whose first moment was at `start` that `options` state, all in
/// times after `zero`. [s]
RecordedMotion partOf(const RecordedMotion& motion, double start, double zero,
                      const std::string& name, const ReadOptions& options) {
  if (!options.from && !options.to) return motion;
  const double end = start + motion.duration();
  // A calendar's times are stated to the rounding of a double.
  const double room = zero == 0 ? 0 : 1e-6;
  const auto near = [&](double time, double other) {
    return std::abs(time - other) <= room ? other : time;
  };
  const double from = near(options.from.value_or(start), start);
  const double to = near(options.to.value_or(end), end);
  if (from >= start && to <= end && from < to) return motion.part(from - start, to - start);
  const auto text = [&](double time) { return shortestText(zero + time); };
  throw InputError(name + ": the part from " + text(from) + " to " + text(to) +
                   " s isn't within the recording, which lasts from " + text(start) + " to " +
                   text(end) + " s");
}

/// Returns the options with the stated part in times after `zero`. [s]
ReadOptions after(double zero, ReadOptions options) {
  if (options.from) *options.from -= zero;
  if (options.to) *options.to -= zero;
  return options;
}

std::string droppedNote(const SensorRows& rows) {
  if (rows.dropped == 0) return "";
  return countText(static_cast<std::int64_t>(rows.dropped), "row") +
         (rows.dropped == 1 ? " at the table's ends has no reading and is left out"
                            : " at the table's ends have no reading and are left out");
}

SpinSource sourceOf(const Columns& columns) {
  if (!hasAttitudes(columns)) return SpinSource::Gyroscope;
  return columns.rates ? SpinSource::Given : SpinSource::Slopes;
}

/// A part of a recording without its flaws, and what these are.
struct SoundPart {
  std::vector<RecordedMoment> moments;
  std::vector<std::string> flaws{};  // textsOf()
  double largestStray = 0;           // [rad]
};

SoundPart soundPartOf(std::vector<RecordedMoment> moments, SpinSource source, double zero) {
  if (moments.size() < 2) return {std::move(moments)};
  const Flaws flaws = flawsIn(moments, source);
  if (!flaws.areAny()) return {std::move(moments)};
  return {withoutFlaws(flaws, moments, source),
          textsOf(flaws, moments, zero + moments.front().time), flaws.largestTurn()};
}

/// Returns the facts of the spins of a part without flaws.
SpinFacts factsOf(const SoundPart& sound, const Columns& columns, SpinSource source,
                  const std::string& name) {
  if (source == SpinSource::Given) return factsOf(sound.moments, columns, name, sound.flaws);
  SpinFacts facts{source};
  if (source == SpinSource::Slopes) facts.uncertainty = slopeUncertainty(sound.moments);
  if (source == SpinSource::Gyroscope) facts.unknownTurn = unknownTurnIn(ratesOf(sound.moments));
  return facts;
}

}  // namespace

RecordedMotion readRecording(std::string_view bytes, const std::string& name,
                             const ReadOptions& stated) {
  const CsvTable table(bytes, name);
  const Columns columns = findColumns(table, stated);
  const SensorRows rows = sensorRows(table, columns, false);
  const double zero = zeroOf(table, columns, rows.motion.front());
  const ReadOptions options = after(zero, stated);
  const std::vector<double> times = timesOf(table, columns, rows.motion, zero);
  const SpinSource source = sourceOf(columns);
  const bool areIntegrated = source == SpinSource::Gyroscope;
  std::string heldNote;
  std::vector<RecordedMoment> moments;
  if (areIntegrated) {
    std::vector<Rate> rates = ratesOf(table, columns, rows, times, options.bias);
    heldNote = dropHeldReadings(rates);
    moments = integrateRates(rates);
  } else {
    moments = attitudesOf(table, columns, rows, times, options.bias);
  }
  if (source == SpinSource::Slopes) differentiate(table, rows, moments);
  SoundPart sound = soundPartOf(within(moments, options), source, zero);
  const SpinFacts spins = factsOf(sound, columns, source, name);
  const double start = moments.front().time;
  RecordedMotion motion =
      partOf(RecordedMotion(std::move(moments), spins), start, zero, name, options);
  const double first = zero + std::max(start, options.from.value_or(start));
  for (const std::string& note :
       {droppedNote(rows), heldNote, gapNote(ratesOf(motion.moments()), first, areIntegrated)}) {
    if (!note.empty()) motion.note(note);
  }
  if (!sound.flaws.empty() && sound.moments.size() > 1)
    motion.setFlaws(sound.flaws, sound.largestStray,
                    RecordedMotion(std::move(sound.moments), spins));
  return motion;
}

InertialRecording readInertial(std::string_view bytes, const std::string& name,
                               const ReadOptions& options, const NamedTable* acceleration) {
  const CsvTable table(bytes, name);
  const Columns columns =
      findColumns(table, acceleration == nullptr ? options : withoutForce(options));
  const bool isOneTable = acceleration == nullptr && columns.acceleration;
  const SensorRows rows = sensorRows(table, columns, isOneTable);
  InertialRecording recording;
  recording.zero = zeroOf(table, columns, rows.motion.front());
  recording.hasForce = acceleration != nullptr || columns.acceleration;
  recording.isMeasured = columns.rates.has_value();
  const std::vector<double> times = timesOf(table, columns, rows.motion, recording.zero);
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  std::vector<Rate> rates = hasAttitudes(columns) ? ratesBeside(table, columns, rows, times, name)
                                                  : ratesOf(table, columns, rows, times, none);
  const std::string heldNote = recording.isMeasured ? dropHeldReadings(rates) : "";
  for (const Rate& rate : rates) recording.readings.push_back({rate});
  if (isOneTable) addForces(recording, forcesOf(table, columns, rows.force, recording.zero), name);
  if (acceleration != nullptr)
    addForces(recording, forcesIn(*acceleration, options, recording.zero), acceleration->name);
  for (const std::string& note : {droppedNote(rows), heldNote}) {
    if (!note.empty()) recording.notes.push_back(note);
  }
  return recording;
}

Contents contentsOf(const NamedTable& named, const ReadOptions& options) {
  constexpr std::size_t kBeginning = 1 << 16;  // [bytes]
  const std::string_view beginning = named.bytes.substr(0, kBeginning);
  std::string decoded;
  std::string_view text = textOfFile(beginning, decoded);
  if (beginning.size() < named.bytes.size()) text = text.substr(0, text.find_last_of("\r\n"));
  try {
    const CsvTable table(text, named.name);
    const Columns columns = columnsIn(table, withoutMissing(options, table));
    return {columns.rates.has_value(), hasAttitudes(columns), columns.acceleration.has_value()};
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace rotatebook::recording
