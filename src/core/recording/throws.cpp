#include "recording/throws.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Eigenvalues>

#include "base/number_text.h"
#include "recording/gaps.h"

namespace rotatebook::recording {
namespace {

constexpr double kLargestChange = 0.03;  // of the angular momentum, root mean square
constexpr double kLargestAtEnd = 0.06;   // of a reading that a flight grows by
constexpr double kStride = 0.02;         // between the stretches that are tried [s]
constexpr double kLongestGap = 0.5;      // within a stretch [s]

/// A free body that a stretch's readings may be of.
struct FreeBody {
  Entries entries = Entries::Zero();              // of its tensor
  Eigen::Vector3d first{0, 0, 0}, last{0, 0, 0};  // angular momentum before all gaps, and after
  double change = 0;  // of the angular momentum, root mean square over its size
};

/// Returns whether a body can have the tensor, or nearly.
bool isBodys(const Eigen::Matrix3d& tensor) {
  Eigen::Vector3d moments = principalMoments(tensor);
  if (moments.sum() < 0) moments = -moments.reverse().eval();
  constexpr double kThinnest = 0.01, kRoom = 0.5;
  return moments[0] > kThinnest * moments[2] && moments[0] + moments[1] > kRoom * moments[2];
}

std::string percentOf(double part) {
  return roundedText(100 * part, 2) + " %";
}

/// A stretch of fast readings, and the search for flights in it.
class Stretch {
 public:
  explicit Stretch(Readings readings) {
    std::vector<Rate> rates;
    for (const InertialReading& one : readings) rates.push_back(one.rate);
    moments_ = integrateRates(rates);
    breaks_ = breaksIn(rates);
  }

  /// Returns the flights.
  std::vector<Range> flights() const {
    struct Seed {
      Range range;
      double change;
    };
    std::vector<Seed> seeds;
    for (const Range& window : windows()) {
      if (const auto body = bodyIn(window)) seeds.push_back({window, body->change});
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

  /// Returns the least change of any body's angular momentum in a shortest stretch within `range`,
  /// root mean square; infinite if there is none. [-]
  double leastChange(Range range) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Range& window : windows()) {
      const bool isWithin = window.first >= range.first && window.second <= range.second;
      if (isWithin) least = std::min(least, nearestBody(window).change);
    }
    return least;
  }

  /// Returns how long the first ten readings take. [s]
  double durationOfTen() const { return moments_[kMinReadings - 1].time - moments_.front().time; }

 private:
  /// Returns the shortest stretches that may be a flight.
  std::vector<Range> windows() const {
    std::vector<Range> windows;
    for (std::size_t first = 0; first < moments_.size(); first = after(first, kStride)) {
      const std::size_t end = std::max(after(first, kShortestThrow), first + kMinReadings);
      if (end > moments_.size()) break;
      windows.push_back({first, end});
    }
    return windows;
  }

  /// Returns the first reading at least `interval` after reading `index`, which isn't it. [s]
  std::size_t after(std::size_t index, double interval) const {
    const double time = moments_[index].time + interval;
    std::size_t next = index + 1;
    while (next < moments_.size() && moments_[next].time < time) ++next;
    return next;
  }

  bool isBreak(std::size_t index) const {
    return std::binary_search(breaks_.begin(), breaks_.end(), index);
  }

  /// Returns the body whose free motion the readings are; nothing if they aren't any's.
  std::optional<FreeBody> bodyIn(Range range) const {
    const FreeBody body = nearestBody(range);
    const Eigen::Matrix3d tensor = tensorFrom(body.entries);
    if (!(body.change < kLargestChange) || !isBodys(tensor)) return std::nullopt;
    // In a gap the same body may have been thrown again.
    for (const std::size_t index : breaks_) {
      const bool isWithin = index > range.first && index < range.second;
      if (isWithin && !isContinued(tensor, index)) return std::nullopt;
    }
    return body;
  }

  /// Returns the body whose angular momentum changes least, but for gaps across which the attitude
  /// isn't known.
  FreeBody nearestBody(Range range) const {
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    std::vector<MomentumMatrix> means;
    for (std::size_t start = range.first, end = start; start < range.second; start = end) {
      do ++end;
      while (end < range.second && !isBreak(end));
      const MomentumMatrix mean = meanMomentum(moments_, start, end);
      means.push_back(mean);
      for (std::size_t i = start; i < end; ++i) {
        const MomentumMatrix difference = momentumMatrix(moments_[i]) - mean;
        sum += difference.transpose().lazyProduct(difference);
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(sum);
    FreeBody body{solver.eigenvectors().col(0)};
    body.first = means.front() * body.entries;
    body.last = means.back() * body.entries;
    const auto count = static_cast<double>(range.second - range.first);
    const double size = (body.first.norm() + body.last.norm()) / 2;
    body.change = std::sqrt(std::max(solver.eigenvalues()[0], 0.0) / count) / size;
    return body;
  }

  /// Returns whether the reading before or after a body's range is of its motion.
  bool fits(const FreeBody& body, std::size_t index, bool isAfter) const {
    const std::size_t later = isAfter ? index : index + 1;
    if (isBreak(later)) return isContinued(tensorFrom(body.entries), later);
    const Eigen::Vector3d& momentum = isAfter ? body.last : body.first;
    const Eigen::Vector3d change = momentumMatrix(moments_[index]) * body.entries - momentum;
    return change.norm() < kLargestAtEnd * momentum.norm();
  }

  /// Returns whether a reading after a gap is as a free body's motion leads there.
  bool isContinued(const Eigen::Matrix3d& tensor, std::size_t after) const {
    const RecordedMoment &from = moments_[after - 1], &to = moments_[after];
    const Eigen::Vector3d spin = freeSpinAfter(tensor, from.angularVelocity, to.time - from.time);
    return (spin - to.angularVelocity).norm() < kLargestAtEnd * to.angularVelocity.norm();
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
        if (isOther(range.second) || !fits(*body, range.second, true)) break;
        if (isBreak(range.second++)) break;  // What follows it has an angular momentum of its own.
      }
      for (std::size_t i = 0; i < step && range.first > 0; ++i) {
        if (isOther(range.first - 1) || !fits(*body, range.first - 1, false)) break;
        if (isBreak(range.first--)) break;
      }
      grows = range != before;
    }
    return range;
  }

  std::vector<RecordedMoment> moments_;
  std::vector<std::size_t> breaks_;
};

/// Returns the runs of fast readings without long gaps, each that lasts long enough for a flight.
std::vector<Range> fastRuns(const InertialRecording& recording) {
  const auto& all = recording.readings;
  const auto timeOf = [&](std::size_t i) { return all[i].rate.time; };
  std::vector<Range> runs;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= all.size(); ++i) {
    const bool isFast = i < all.size() && all[i].rate.angularVelocity.norm() > kSlowestThrow;
    const bool isGap = i > start && i < all.size() && timeOf(i) - timeOf(i - 1) > kLongestGap;
    if (isFast && !isGap) continue;
    if (i > start && timeOf(i - 1) - timeOf(start) >= kShortestThrow) runs.push_back({start, i});
    start = isFast ? i : i + 1;
  }
  return runs;
}

/// Returns why there is no flight where angular momentum changes by `change` at least over ten
/// readings, which take so long. [-, s]
std::string problemOf(double change, double tenReadings) {
  if (change < kLargestChange) {
    return "it isn't a free flight: only moments that no body has would fit it, as where it spins "
           "too steadily to tell, or where each axis has its own scale";
  }
  const bool areFew = tenReadings > kShortestThrow;
  return std::string(areFew ? "no free flight was found" : "it isn't a free flight") +
         ": no body's angular momentum would stay within " + percentOf(kLargestChange) + " for " +
         roundedText(std::max(tenReadings, kShortestThrow), 2) +
         " s (root mean square), at best within " + percentOf(change) +
         (areFew ? "; a shorter flight has fewer than " + std::to_string(kMinReadings) +
                       " readings: record more of them a second"
                 : "");
}

std::string tooFewText(std::size_t count) {
  return "there are " + std::to_string(count) + " readings, but a flight takes at least " +
         std::to_string(kMinReadings) + "; record more of them a second";
}

}  // namespace

std::vector<FastStretch> fastStretches(const InertialRecording& recording) {
  std::vector<FastStretch> stretches;
  for (const Range& run : fastRuns(recording)) {
    const Range whole{0, run.second - run.first};
    if (whole.second < kMinReadings) {
      stretches.push_back({run, run, tooFewText(whole.second)});
      continue;
    }
    const Stretch stretch(Readings(recording.readings).subspan(run.first, whole.second));
    std::vector<Range> flights = stretch.flights();
    std::ranges::sort(flights);
    flights.push_back({whole.second, whole.second});
    std::size_t start = 0;
    for (const Range& one : flights) {
      const Range flight{run.first + one.first, run.first + one.second};
      const Range trimmed = withoutEnds(flight);
      const bool isEnough = trimmed.second - trimmed.first >= kMinReadings;
      if (one != Range{whole.second, whole.second})
        stretches.push_back({isEnough ? trimmed : flight, run});
      const Range before{start, one.first};
      const double change = stretch.leastChange(before);
      // Beside a flight, what a hand does isn't told.
      if (change < kLargestChange || before == whole)
        stretches.push_back({{run.first + start, run.first + one.first},
                             run,
                             problemOf(change, stretch.durationOfTen())});
      start = one.second;
    }
  }
  std::ranges::sort(stretches, {}, &FastStretch::range);
  return stretches;
}

}  // namespace rotatebook::recording
