#include "recording/toss.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "recording/flight.h"
#include "recording/free_part.h"
#include "recording/gaps.h"

namespace rotatebook::recording {
namespace {

constexpr double kWidest = 0.5;  // interval of a ratio
// Residual of a fit that other errors than noise make, in multiples of the noise at rest. Steady
// spins leave 1, measured.
constexpr double kMuch = 5;

Eigen::Vector2d ratiosOf(const Parameters& p) {
  const Eigen::Vector3d moments = principalMoments(tensorOf(p));
  return moments.head<2>() / moments[2];
}

/// Returns the ratios with their intervals, by the slopes of the ratios.
std::array<Estimate, 2> estimatesOf(const FreeSpinFit& fit, std::size_t readings, double widening) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix<double, 2, kParameters> slopes;
  for (int i = 0; i < kParameters; ++i) {
    Parameters up = fit.parameters, down = fit.parameters;
    up[i] += kStep;
    down[i] -= kStep;
    slopes.col(i) = (ratiosOf(up) - ratiosOf(down)) / (2 * kStep);
  }
  const Eigen::Matrix2d covariance = slopes * fit.covariance * slopes.transpose();
  const Eigen::Vector2d ratios = ratiosOf(fit.parameters);
  // Student's quantile for 95 %, to 1 % from 20 degrees of freedom on.
  const double quantile = 1.96 + 2.4 / (3.0 * static_cast<double>(readings) - kParameters);
  std::array<Estimate, 2> estimates;
  for (int i = 0; i < 2; ++i) {
    const double half = widening * quantile * std::sqrt(covariance(i, i));
    estimates[static_cast<std::size_t>(i)] = {ratios[i], ratios[i] - half, ratios[i] + half};
  }
  return estimates;
}

/// Cuts the intervals to what bodies can have, I1 <= I2 <= I3 <= I1 + I2, without their values.
void cutToBodies(std::array<Estimate, 2>& ratios) {
  auto& [smallest, middle] = ratios;
  const auto cut = [](Estimate& ratio, double low, double high) {
    ratio.low = std::max(ratio.low, std::min(low, ratio.value));
    ratio.high = std::min(ratio.high, std::max(high, ratio.value));
  };
  cut(middle, 0.5, 1);
  cut(smallest, std::max(0.0, 1 - middle.high), middle.high);
}

/// Returns the tensor of a body, as a multiple of its largest moment.
Eigen::Matrix3d bodysTensor(const Eigen::Matrix3d& tensor) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(tensor);
  Eigen::Vector3d moments = axes.eigenvalues();
  // No moment is larger than the sum of the others, with some room for rounding
  constexpr double kRoom = 1e-9;
  moments[2] = std::min(moments[2], (moments[0] + moments[1]) * (1 - kRoom));
  const Eigen::Matrix3d result =
      axes.eigenvectors() * (moments / moments[2]).asDiagonal() * axes.eigenvectors().transpose();
  return (result + result.transpose()) / 2;
}

/// Refuses a motion. Where the fit leaves much more than the noise at rest, it is other errors that
/// hide the inertia, and not the motion.
[[noreturn]] void refuse(const std::string& name, const std::string& reason, const TossFit& fit) {
  const bool haveErrors = fit.noise > 0 && fit.residual > kMuch * fit.noise;
  const std::string remedy =
      haveErrors ? "any body's free motion differs from the rates by " +
                       roundedText(fit.residual / fit.noise, 2) +
                       " times the noise at rest, as where a hand still holds it, an axis has "
                       "another scale, axes aren't square to each other, or times are wrong: state "
                       "the flight alone with --from and --to, or calibrate the gyroscope"
                 : "toss the body so that it tumbles, spun about its middle axis";
  throw InputError(name + ": the motion doesn't tell the inertia: " + reason + "; " + remedy);
}

std::string degreesASecond(double rate) {
  return roundedText(rate * 180 / std::numbers::pi, 3) + " deg/s";
}

[[noreturn]] void failStretch(const std::string& name, double from, double to,
                              const std::string& problem) {
  throw InputError(name + ": from " + timeText(from) + " to " + timeText(to) + " s " + problem);
}

[[noreturn]] void refuseFlight(const TossFit& fit, const std::string& name,
                               const std::string& reason) {
  failStretch(name, fit.from, fit.to,
              "it isn't a free flight: " + reason +
                  "; state the flight alone with --from and --to, or find it with --list");
}

std::string percentText(double part) {
  return roundedText(100 * part, 2) + " %";
}

void requireFree(const TossFit& fit, const std::string& name) {
  if (fit.residual <= kLargestResidual * fit.spin) return;
  refuseFlight(fit, name,
               "no body's free motion comes closer than " + degreesASecond(fit.residual) +
                   " (root mean square), more than " + percentText(kLargestResidual) +
                   " of the spin of " + degreesASecond(fit.spin));
}

/// Refuses a flight in which no body's angular momentum stays.
void requireMomentum(const Linear& linear, const TossFit& fit, const std::string& name) {
  if (linear.gap >= kSmallestGap || linear.change <= kLargestResidual) return;
  refuseFlight(fit, name,
               "any body's angular momentum would change by " + percentText(linear.change) +
                   " (root mean square)");
}

void requireGap(const TossFit& fit, const std::string& name) {
  if (fit.gap >= kSmallestGap) return;  // NaN is refused.
  refuse(name,
         "the gap of its singular values is " + roundedText(fit.gap, 3) + ", which is less than " +
             roundedText(kSmallestGap, 1),
         fit);
}

/// Returns the step of rounded numbers: the smallest change from one to the next, or of such
/// changes, but at least a millionth of the largest number.
double stepOf(const std::vector<double>& rates, double largest) {
  const double floor = 1e-6 * largest;
  double step = std::numeric_limits<double>::infinity(), before = 0;
  const auto take = [&](double change) {
    if (std::abs(change) > floor) step = std::min(step, std::abs(change));
  };
  for (std::size_t i = 1; i < rates.size(); ++i) {
    const double change = rates[i] - rates[i - 1];
    take(change);
    if (i > 1) take(change - before);
    before = change;
  }
  return std::max(step, floor);
}

/// Returns whether one of `count` readings from the `i`-th on, by `stride`, is smaller than `size`.
bool fallsBelow(double size, const std::vector<double>& rates, std::ptrdiff_t i,
                std::ptrdiff_t stride, std::size_t count) {
  for (; count > 0 && i >= 0 && i < std::ssize(rates); i += stride, --count) {
    if (std::abs(rates[static_cast<std::size_t>(i)]) < size) return true;
  }
  return false;
}

/// Returns whether an axis stays at its extreme value for at least four readings, and five times as
/// long as it takes to come there or to leave it by more than two steps of rounded numbers: at the
/// top of a smooth curve these take longer.
bool isClipped(const std::vector<InertialReading>& flight, const std::vector<double>& rates,
               double largest) {
  constexpr double kSteps = 2.5;
  constexpr std::size_t kTimes = 5;
  const double below = largest - kSteps * stepOf(rates, largest);
  for (std::size_t begin = 0, end = 0; begin < rates.size(); begin = end + 1) {
    std::size_t run = 0;
    for (end = begin; end < rates.size() && std::abs(rates[end]) == largest; ++end) {
      // A reading that is held for several rows isn't clipped.
      const bool isHeld =
          end > 0 && flight[end].rate.angularVelocity == flight[end - 1].rate.angularVelocity;
      run += isHeld ? 0 : 1;
    }
    const std::size_t count = (run + 1) / kTimes;
    if (fallsBelow(below, rates, static_cast<std::ptrdiff_t>(begin) - 1, -1, count) ||
        fallsBelow(below, rates, static_cast<std::ptrdiff_t>(end), 1, count))
      return true;
  }
  return false;
}

/// Refuses a flight in which an axis stays at its extreme value for several readings.
void requireUnclipped(const std::vector<InertialReading>& flight, const std::string& name) {
  constexpr double kLowestRange = 4;  // of gyroscopes, 250 deg/s [rad/s]
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> rates;
    double largest = 0;
    for (const InertialReading& one : flight) {
      rates.push_back(one.rate.angularVelocity[axis]);
      largest = std::max(largest, std::abs(rates.back()));
    }
    if (largest < kLowestRange || !isClipped(flight, rates, largest)) continue;
    throw InputError(name + ": the gyroscope clips at " + degreesASecond(largest) + " about " +
                     "xyz"[axis] + ": it stays at that value; toss the body more slowly");
  }
}

void requireTelling(const TossFit& fit, const std::string& name) {
  for (const Estimate& ratio : fit.ratios) {
    const double width = ratio.high - ratio.low;
    if (width <= kWidest && ratio.value > 0) continue;
    refuse(name,
           "a ratio of moments is " + roundedText(ratio.value, 3) + ", with an interval that is " +
               roundedText(width, 2) + " wide",
           fit);
  }
  const auto& [smallest, middle] = fit.ratios;
  if (smallest.high + middle.high >= 1) return;
  throw InputError(name + ": the ratios of moments are " + roundedText(smallest.value, 4) +
                   " and " + roundedText(middle.value, 4) +
                   ", but those of a body add up to 1 or more; is a column's sign or scale wrong?");
}

/// Returns the factor of the intervals of a fit whose residual is larger than the noise at rest by
/// more than chance: what isn't noise is taken to be alike for a quarter of the flight.
double wideningFor(double residual, const Rest& rest, std::size_t readings) {
  if (!(rest.noise > 0)) return 1;
  constexpr double kQuarters = 4;
  const auto count = static_cast<double>(readings);
  const double chance =
      2 * std::sqrt(2 / (3 * count) + 2 / (3 * static_cast<double>(rest.readings)));
  const double ratio = residual * residual / (rest.noise * rest.noise) / (1 + chance);
  if (ratio <= 1) return 1;
  return std::sqrt(std::max(1.0, (1 + (ratio - 1) * count / kQuarters) / ratio));
}

double spinOf(Readings flight) {
  double sum = 0;
  for (const InertialReading& one : flight) sum += one.rate.angularVelocity.squaredNorm();
  return std::sqrt(sum / static_cast<double>(flight.size()));
}

/// Returns that no gyroscope measures these rates; empty if one may. A factor of the rates isn't
/// told by the fit: it makes another body.
std::string rangeNote(const std::vector<Rate>& rates) {
  constexpr double kRange = 80;  // of the fastest gyroscopes, 4000 deg/s, and a little more [rad/s]
  double largest = 0;
  for (const Rate& rate : rates)
    largest = std::max(largest, rate.angularVelocity.cwiseAbs().maxCoeff());
  if (largest <= kRange) return "";
  return "the rates reach " + degreesASecond(largest) +
         ", more than gyroscopes measure: if they are raw counts or in another unit, the ratios "
         "are wrong";
}

/// Returns the fit to the readings of a flight.
TossFit fitFlight(const InertialRecording& recording, const std::string& name, Range range) {
  Rest rest = restBefore(Readings(recording.readings).first(range.first));
  if (!recording.isMeasured) rest = Rest{};  // Slopes have no bias.
  TossFit result;
  result.bias = rest.bias;
  result.rest = rest.duration;
  result.noise = rest.noise;
  result.isMeasured = recording.isMeasured;
  result.notes = recording.notes;
  std::vector<InertialReading> flight(
      recording.readings.begin() + static_cast<std::ptrdiff_t>(range.first),
      recording.readings.begin() + static_cast<std::ptrdiff_t>(range.second));
  requireUnclipped(flight, name);
  std::vector<Rate> rates;
  for (InertialReading& one : flight) {
    one.rate.angularVelocity -= result.bias;
    rates.push_back(one.rate);
  }
  result.from = recording.zero + flight.front().rate.time;
  result.to = recording.zero + flight.back().rate.time;
  result.readings = flight.size();
  result.spin = spinOf(flight);
  const std::string beyond = recording.isMeasured ? rangeNote(rates) : "";
  for (const std::string& note : {gapNote(rates, recording.zero, true), beyond}) {
    if (!note.empty()) result.notes.push_back(note);
  }

  const Linear linear = solveLinear(flight);
  result.gap = linear.gap;
  requireMomentum(linear, result, name);
  const Parameters start = parametersOf(linear.tensor, flight.front().rate.angularVelocity);
  if (!isFollowed(flight, start)) requireGap(result, name);
  const FreeSpinFit fit = nearestFreeSpin(
      flight, start, biasVariance(rest, (result.from + result.to) / 2 - recording.zero),
      rest.noise);
  result.residual = fit.residual;
  requireGap(result, name);
  requireFree(result, name);
  result.widening = wideningFor(fit.residual, rest, flight.size());
  result.ratios = estimatesOf(fit, flight.size(), result.widening);
  requireTelling(result, name);
  cutToBodies(result.ratios);
  result.start = fit.parameters.tail<3>();
  result.inertia = bodysTensor(tensorOf(fit.parameters));
  return result;
}

/// Returns the throw that a range is, with its fit or why that is refused.
Throw throwIn(const InertialRecording& recording, const std::string& name, Range range,
              const std::string& problem) {
  Throw one;
  one.from = recording.zero + recording.readings[range.first].rate.time;
  one.to = recording.zero + recording.readings[range.second - 1].rate.time;
  one.isFlight = problem.empty();
  one.spin = spinOf(Readings(recording.readings).subspan(range.first, range.second - range.first));
  try {
    if (!problem.empty()) failStretch(name, one.from, one.to, problem);
    requireFew(range, name);
    one.fit = fitFlight(recording, name, range);
  } catch (const InputError& error) {
    one.refusal = error.what();
  }
  return one;
}

/// Returns how fast the body turns at most, where that is too slow for a throw; else nothing.
std::string slownessOf(const InertialRecording& recording) {
  double fastest = 0;
  for (const InertialReading& one : recording.readings)
    fastest = std::max(fastest, one.rate.angularVelocity.norm());
  if (fastest > kSlowestThrow) return "";
  return ", which reach " + degreesASecond(fastest) + ", though throws are faster than " +
         degreesASecond(kSlowestThrow) + "; state their unit if it is another";
}

/// Returns the only throw that is accepted.
TossFit onlyThrow(const InertialRecording& recording, const std::string& name,
                  const TossOptions& options) {
  const std::vector<Throw> throws = findThrows(recording, name, options);
  std::vector<std::string> accepted;
  const Throw* last = nullptr;
  for (const Throw& one : throws) {
    if (!one.fit) continue;
    last = &one;
    accepted.push_back(timeText(one.from) + " to " + timeText(one.to));
  }
  if (accepted.size() == 1) return *last->fit;
  if (throws.size() == 1) throw InputError(throws.front().refusal);  // No flight, or not telling.
  if (throws.empty()) {
    throw InputError(name + ": no throw was found in the rates alone" + slownessOf(recording) +
                     "; state the flight with --from and --to");
  }
  constexpr std::size_t kShown = 8;
  const std::size_t count = accepted.size();
  if (count > kShown) {
    accepted.resize(kShown);
    accepted.push_back(std::to_string(count - kShown) + " more");
  }
  throw InputError(name + ": " +
                   (count == 0 ? "none of " + std::to_string(throws.size()) +
                                     " fast stretches tells the inertia; --list says why"
                               : std::to_string(count) + " throws, at " + listed(accepted) +
                                     " s; state one with --from and --to, or print all with "
                                     "--list"));
}

}  // namespace

std::optional<Flight> findFlight(const InertialRecording& recording) {
  const auto [first, end] = longestFlight(recording, TossOptions{}.lever);
  if (end - first < kMinReadings) return {};
  const auto &from = recording.readings[first].rate, &to = recording.readings[end - 1].rate;
  return Flight{recording.zero + from.time, recording.zero + to.time, from.angularVelocity};
}

TossFit fitToss(const InertialRecording& recording, const std::string& name,
                const TossOptions& options) {
  const bool isStated = options.from || options.to;
  if (!isStated && !recording.hasForce) return onlyThrow(recording, name, options);
  return fitFlight(recording, name, flightIn(recording, name, options));
}

std::vector<Throw> findThrows(const InertialRecording& recording, const std::string& name,
                              const TossOptions& options) {
  std::vector<Throw> throws;
  const auto timeOf = [&](std::size_t i) {
    return recording.zero + recording.readings[i].rate.time;
  };
  for (const auto& [stretch, part] : freeStretches(recording)) {
    const double from = timeOf(stretch.range.first), to = timeOf(stretch.range.second - 1);
    if (from < options.from.value_or(from) || to > options.to.value_or(to)) continue;
    Throw one = throwIn(recording, name, part, stretch.problem);
    if (!one.fit && part != stretch.range) {
      Throw whole = throwIn(recording, name, stretch.range, stretch.problem);
      if (whole.fit) one = std::move(whole);
    }
    throws.push_back(std::move(one));
  }
  return throws;
}

}  // namespace rotatebook::recording
