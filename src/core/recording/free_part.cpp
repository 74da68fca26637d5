#include "recording/free_part.h"

#include <algorithm>
#include <optional>

#include <Eigen/LU>

namespace rotatebook::recording {
namespace {

/// A free motion, which is followed from reading to reading.
class FittedMotion {
 public:
  FittedMotion(Readings run, Range range, const FreeSpinFit& fit)
      : run_(run), tensor_(tensorOf(fit.parameters)), first_(range.first), last_(first_) {
    before_ = after_ = fit.parameters.tail<3>();
    while (last_ + 1 < range.second) errorAfter();
  }

  /// Returns how far the next reading is from the motion. [rad/s]
  double errorAfter() {
    after_ = freeSpinAfter(tensor_, after_, timeOf(last_ + 1) - timeOf(last_));
    ++last_;
    return (run_[last_].rate.angularVelocity - after_).norm();
  }

  /// Returns likewise for the reading before. A free spin that is turned round runs back.
  double errorBefore() {
    before_ = -freeSpinAfter(tensor_, -before_, timeOf(first_) - timeOf(first_ - 1));
    --first_;
    return (run_[first_].rate.angularVelocity - before_).norm();
  }

 private:
  double timeOf(std::size_t index) const { return run_[index].rate.time; }

  Readings run_;
  Eigen::Matrix3d tensor_;
  Eigen::Vector3d before_, after_;
  std::size_t first_, last_;
};

/// Returns the free motion that fits a part; nothing if its readings can't be followed.
std::optional<FreeSpinFit> fitOfPart(Readings part, double noise) {
  const Linear linear = solveLinear(part);
  const Parameters start = parametersOf(linear.tensor, part.front().rate.angularVelocity);
  if (!isFollowed(part, start)) return std::nullopt;
  FreeSpinFit fit = nearestFreeSpin(part, start, Eigen::Vector3d::Zero(), noise);
  if (!(principalMoments(tensorOf(fit.parameters))[0] > 0)) return std::nullopt;
  return fit;
}

/// Returns a part with the readings on both sides that its motion leads to, an eighth more at most.
Range grownPart(Readings run, Range part, const FreeSpinFit& fit, double noise) {
  constexpr double kSigmas = 6;
  const double limit = kSigmas * std::max(noise, fit.residual);
  const std::size_t step = (part.second - part.first) / 8 + 1;
  FittedMotion motion(run, part, fit);
  Range grown = part;
  for (std::size_t i = 0; i < step && grown.second < run.size(); ++i) {
    if (!(motion.errorAfter() < limit)) break;
    ++grown.second;
  }
  for (std::size_t i = 0; i < step && grown.first > 0; ++i) {
    if (!(motion.errorBefore() < limit)) break;
    --grown.first;
  }
  return grown;
}

/// Returns the part of a fast run that one free motion fits: it grows from the middle half of a
/// flight as far as the motion that is fitted there leads to what is read, within six times the
/// noise or what the fit leaves. The rates are without bias; `noise` is that at rest, or 0. [rad/s]
/// Returns the flight where that doesn't lead to a part of kMinReadings.
Range freePart(Readings run, Range flight, double noise) {
  const std::size_t quarter = (flight.second - flight.first) / 4;
  Range part{flight.first + quarter, flight.second - quarter};
  if (part.second - part.first < kMinReadings) return flight;
  for (bool grows = true; grows;) {
    const auto fit = fitOfPart(run.subspan(part.first, part.second - part.first), noise);
    if (!fit) return flight;
    const Range grown = grownPart(run, part, *fit, noise);
    grows = grown != part;
    part = grown;
  }
  return part;
}

/// Returns the part of a fast run that is one free motion, of a stretch that is a flight; else the
/// stretch.
Range freePartOf(const InertialRecording& recording, const FastStretch& stretch) {
  const auto& [range, run, problem] = stretch;
  if (!problem.empty() || run.second - run.first > kMaxReadings) return range;
  const Rest rest = restBefore(Readings(recording.readings).first(range.first));
  std::vector<InertialReading> readings(
      recording.readings.begin() + static_cast<std::ptrdiff_t>(run.first),
      recording.readings.begin() + static_cast<std::ptrdiff_t>(run.second));
  for (InertialReading& one : readings) {
    if (recording.isMeasured) one.rate.angularVelocity -= rest.bias;
  }
  const Range flight{range.first - run.first, range.second - run.first};
  const Range part = freePart(readings, flight, recording.isMeasured ? rest.noise : 0);
  return {run.first + part.first, run.first + part.second};
}

}  // namespace

std::vector<FreeStretch> freeStretches(const InertialRecording& recording) {
  std::vector<FreeStretch> all, kept;
  for (const FastStretch& one : fastStretches(recording))
    all.push_back({one, freePartOf(recording, one)});
  const auto lengthOf = [](const FreeStretch& one) { return one.part.second - one.part.first; };
  for (const FreeStretch& one : all) {
    const std::size_t middle = (one.stretch.range.first + one.stretch.range.second) / 2;
    const bool isWithin = std::ranges::any_of(all, [&](const FreeStretch& other) {
      const bool isLonger =
          lengthOf(other) > lengthOf(one) || (lengthOf(other) == lengthOf(one) && &other < &one);
      return other.stretch.problem.empty() && isLonger && other.part.first <= middle &&
             middle < other.part.second;
    });
    if (!isWithin) kept.push_back(one);
  }
  return kept;
}

}  // namespace rotatebook::recording
