#include "recording/flight.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace rotatebook::recording {
namespace {

constexpr double kFreeForce = 2;       // [m/s^2]
constexpr double kSlowest = 1;         // of a toss [rad/s]
constexpr double kRest = 0.15;         // largest rate of a rest [rad/s]
constexpr double kShortestRest = 0.2;  // [s]
constexpr double kTrimmed = 0.02;      // of a flight, at each end

Range between(const InertialRecording& recording, double from, double to) {
  const auto& all = recording.readings;
  const auto isIn = [&](const InertialReading& one) {
    return one.rate.time >= from && one.rate.time <= to;
  };
  const auto first = std::find_if(all.begin(), all.end(), isIn);
  const auto end = std::find_if_not(first, all.end(), isIn);
  return {static_cast<std::size_t>(first - all.begin()),
          static_cast<std::size_t>(end - all.begin())};
}

/// Returns the noise of a rate by the differences between neighbours, which slow turns hardly
/// change: at least that of rounding to the step between the values.
double noiseOf(Readings readings) {
  double sum = 0, smallest = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const Eigen::Vector3d difference =
        readings[i].rate.angularVelocity - readings[i - 1].rate.angularVelocity;
    sum += difference.squaredNorm();
    for (const double one : difference) {
      const double size = std::abs(one);
      if (size > 0 && (smallest == 0 || size < smallest)) smallest = size;
    }
  }
  const double count = 6.0 * static_cast<double>(readings.size() - 1);
  return std::sqrt(std::max(sum / count, smallest * smallest / 12));
}

Eigen::Vector3d meanOf(Readings readings) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const InertialReading& one : readings)
    mean += one.rate.angularVelocity / static_cast<double>(readings.size());
  return mean;
}

/// Returns the rest that these readings are.
Rest restOf(Readings readings) {
  const auto count = static_cast<double>(readings.size());
  Rest rest;
  rest.readings = readings.size();
  rest.end = readings.back().rate.time;
  rest.duration = rest.end - readings.front().rate.time;
  rest.bias = meanOf(readings);
  for (const InertialReading& one : readings)
    rest.variance += (one.rate.angularVelocity - rest.bias).cwiseAbs2() / (count * (count - 1));
  rest.noise = noiseOf(readings);
  // A walk of variance v a second makes the means of two halves of a rest T differ by v T/3.
  const std::size_t half = readings.size() / 2;
  const Eigen::Vector3d change = meanOf(readings.subspan(half)) - meanOf(readings.first(half));
  const double excess = (change.cwiseAbs2() - 4 * rest.variance).sum() / 3;
  rest.drift = std::max(excess, 0.0) * 3 / rest.duration;
  return rest;
}

}  // namespace

Range withoutEnds(Range range) {
  const std::size_t length = range.second - range.first;
  const auto trim = static_cast<std::size_t>(std::ceil(kTrimmed * static_cast<double>(length)));
  if (length <= 2 * trim) return {0, 0};
  return {range.first + trim, range.second - trim};
}

Range longestFlight(const InertialRecording& recording, double lever) {
  Range longest{0, 0};
  std::size_t start = 0;
  for (std::size_t i = 0; i <= recording.readings.size(); ++i) {
    bool isFree = false;
    if (i < recording.readings.size()) {
      const InertialReading& one = recording.readings[i];
      const double rate = one.rate.angularVelocity.norm();
      isFree = rate > kSlowest && one.force.norm() < kFreeForce + rate * rate * lever;
    }
    if (isFree) continue;
    if (i - start > longest.second - longest.first) longest = {start, i};
    start = i + 1;
  }
  return withoutEnds(longest);
}

void requireFew(Range flight, const std::string& name) {
  const std::size_t count = flight.second - flight.first;
  if (count <= kMaxReadings) return;
  throw InputError(name + ": the flight has " + std::to_string(count) + " readings; up to " +
                   std::to_string(kMaxReadings) +
                   " are fitted: state a shorter one with --from and --to");
}

Range flightIn(const InertialRecording& recording, const std::string& name,
               const TossOptions& options) {
  const bool isStated = options.from || options.to;
  constexpr double kEver = 1e13;  // [s]
  const auto flight = isStated ? between(recording, options.from.value_or(-kEver) - recording.zero,
                                         options.to.value_or(kEver) - recording.zero)
                               : longestFlight(recording, options.lever);
  requireFew(flight, name);
  const std::size_t count = flight.second - flight.first;
  if (count >= kMinReadings) return flight;
  throw InputError(
      name + ": " + (isStated ? "the flight has " : "the longest flight that was found has ") +
      std::to_string(count) + " readings, but at least " + std::to_string(kMinReadings) +
      " are needed; state another with --from and --to");
}

Eigen::Vector3d biasVariance(const Rest& rest, double middle) {
  const double walked =
      rest.duration > 0 ? rest.drift * (rest.duration / 3 + middle - rest.end) : 0;
  return rest.variance + Eigen::Vector3d::Constant(walked);
}

Rest restBefore(Readings before) {
  Rest longest;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= before.size(); ++i) {
    if (i < before.size() && before[i].rate.angularVelocity.norm() < kRest) continue;
    const double length = i > start ? before[i - 1].rate.time - before[start].rate.time : 0;
    if (length > std::max(longest.duration, kShortestRest))
      longest = restOf(before.subspan(start, i - start));
    start = i + 1;
  }
  return longest;
}

}  // namespace rotatebook::recording
