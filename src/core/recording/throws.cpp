#include "recording/throws.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>

#include "recording/sensor_rows.h"

namespace rotatebook::recording {
namespace {

constexpr double kSlowestThrow = 2;      // [rad/s]
constexpr double kShortestThrow = 0.25;  // [s]
constexpr double kLargestChange = 0.03;  // of the angular momentum, root mean square
constexpr double kLargestAtEnd = 0.06;   // of a reading that a flight grows by
constexpr double kStride = 0.02;         // between the stretches that are tried [s]
constexpr double kGapSteps = 4;          // a gap of so many steps ends a stretch

using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Vector9 = Eigen::Matrix<double, 9, 1>;

/// A free body that a stretch's readings may be of.
struct FreeBody {
  Vector9 solution;   // the tensor's entries and the angular momentum over the unit
  double change = 0;  // of the angular momentum, root mean square over its size
};

/// Returns whether a body can have the tensor, or nearly.
bool isBodys(const Eigen::Matrix3d& tensor) {
  Eigen::Vector3d moments = principalMoments(tensor);
  if (moments.sum() < 0) moments = -moments.reverse().eval();
  constexpr double kThinnest = 0.01, kRoom = 0.95;
  return moments[0] > kThinnest * moments[2] && moments[0] + moments[1] > kRoom * moments[2];
}

/// A stretch of fast readings without gaps, and the search for flights in it.
class Stretch {
 public:
  explicit Stretch(Readings readings) {
    std::vector<Rate> rates;
    for (const InertialReading& one : readings) {
      rates.push_back(one.rate);
      unit_ = std::max(unit_, one.rate.angularVelocity.norm());
    }
    moments_ = integrateRates(rates);
  }

  /// Returns the flights.
  std::vector<Range> flights() const {
    struct Seed {
      Range range;
      double change;
    };
    std::vector<Seed> seeds;
    for (std::size_t first = 0; first < moments_.size(); first = after(first, kStride)) {
      const std::size_t end = std::max(after(first, kShortestThrow), first + kMinReadings);
      if (end > moments_.size()) break;
      if (const auto body = bodyIn({first, end})) seeds.push_back({{first, end}, body->change});
    }
    std::ranges::stable_sort(seeds, {}, &Seed::change);
    std::vector<Range> found;
    for (const Seed& seed : seeds) {
      const bool isFree = std::ranges::none_of(found, [&](const Range& other) {
        return seed.range.first < other.second && other.first < seed.range.second;
      });
      if (isFree) found.push_back(grown(seed.range, found));
    }
    return found;
  }

 private:
  /// Returns the first reading at least `interval` after reading `index`, which isn't it. [s]
  std::size_t after(std::size_t index, double interval) const {
    const double time = moments_[index].time + interval;
    std::size_t next = index + 1;
    while (next < moments_.size() && moments_[next].time < time) ++next;
    return next;
  }

  /// Returns the body whose free motion the readings are; nothing if they aren't any's.
  std::optional<FreeBody> bodyIn(Range range) const {
    Matrix9 sum = Matrix9::Zero();
    for (std::size_t i = range.first; i < range.second; ++i) {
      const Eigen::Matrix<double, 3, 9> balance = momentumBalance(moments_[i], unit_);
      sum += balance.transpose().lazyProduct(balance);
    }
    const Eigen::SelfAdjointEigenSolver<Matrix9> solver(sum);
    FreeBody body{solver.eigenvectors().col(0)};
    const auto count = static_cast<double>(range.second - range.first);
    const double size = unit_ * body.solution.tail<3>().norm();
    body.change = std::sqrt(std::max(solver.eigenvalues()[0], 0.0) / count) / size;
    if (!(body.change < kLargestChange) || !isBodys(tensorFrom(body.solution))) return std::nullopt;
    return body;
  }

  bool fits(const FreeBody& body, std::size_t index) const {
    const Eigen::Vector3d change = momentumBalance(moments_[index], unit_) * body.solution;
    return change.norm() < kLargestAtEnd * unit_ * body.solution.tail<3>().norm();
  }

  /// Returns the longest range around a seed that is a free motion and overlaps none of `others`.
  Range grown(Range range, const std::vector<Range>& others) const {
    const auto isOther = [&](std::size_t index) {
      return std::ranges::any_of(others, [index](const Range& other) {
        return other.first <= index && index < other.second;
      });
    };
    for (bool grows = true; grows;) {
      const auto body = bodyIn(range);
      if (!body) break;
      const Range before = range;
      const std::size_t step = (range.second - range.first) / 8 + 1;
      for (std::size_t i = 0; i < step && range.second < moments_.size(); ++i) {
        if (isOther(range.second) || !fits(*body, range.second)) break;
        ++range.second;
      }
      for (std::size_t i = 0; i < step && range.first > 0; ++i) {
        if (isOther(range.first - 1) || !fits(*body, range.first - 1)) break;
        --range.first;
      }
      grows = range != before;
    }
    return range;
  }

  std::vector<RecordedMoment> moments_;
  double unit_ = 0;  // of the angular momentum: the largest rate [rad/s]
};

/// Returns the runs of fast readings without gaps, each long enough for a flight.
std::vector<Range> fastRuns(const InertialRecording& recording) {
  const auto& all = recording.readings;
  std::vector<double> times;
  for (const InertialReading& one : all) times.push_back(one.rate.time);
  const double gap = kGapSteps * medianStep(times);
  std::vector<Range> runs;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= all.size(); ++i) {
    const bool isFast = i < all.size() && all[i].rate.angularVelocity.norm() > kSlowestThrow;
    const bool isGap = i > start && i < all.size() && times[i] - times[i - 1] >= gap;
    if (isFast && !isGap) continue;
    if (i >= start + kMinReadings && times[i - 1] - times[start] >= kShortestThrow)
      runs.push_back({start, i});
    start = isFast ? i : i + 1;
  }
  return runs;
}

}  // namespace

std::vector<Range> flightsByRates(const InertialRecording& recording) {
  std::vector<Range> flights;
  for (const Range& run : fastRuns(recording)) {
    const Stretch stretch(Readings(recording.readings).subspan(run.first, run.second - run.first));
    for (const Range& one : stretch.flights()) {
      const Range flight = withoutEnds({run.first + one.first, run.first + one.second});
      if (flight.second - flight.first >= kMinReadings) flights.push_back(flight);
    }
  }
  std::ranges::sort(flights);
  return flights;
}

}  // namespace rotatebook::recording
