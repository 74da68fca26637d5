#include "timeline/drift.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rotatebook::timeline {
namespace {

/// Returns the deviation of value `i` from the cubic through two neighbours on each side, in
/// standard deviations of what unit noise makes of it.
double deviationAt(std::size_t i, std::span<const double> values, std::span<const double> times) {
  double deviation = values[i], variance = 1;
  for (std::size_t k = i - 2; k <= i + 2; ++k) {
    if (k == i) continue;
    double weight = 1;
    for (std::size_t j = i - 2; j <= i + 2; ++j) {
      if (j != i && j != k) weight *= (times[i] - times[j]) / (times[k] - times[j]);
    }
    deviation -= weight * values[k];
    variance += weight * weight;
  }
  return std::fabs(deviation) / std::sqrt(variance);
}

}  // namespace

double scatterOf(std::span<const double> values, std::span<const double> times) {
  std::vector<double> deviations;
  for (std::size_t i = 2; i + 2 < values.size(); ++i)
    deviations.push_back(deviationAt(i, values, times));
  if (deviations.empty()) return 0;
  constexpr std::size_t kLarger = 50;      // one of so many
  constexpr double kSigmasLarger = 2.326;  // of normal noise
  const std::size_t rank = deviations.size() - 1 - deviations.size() / kLarger;
  const auto limit = deviations.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(deviations.begin(), limit, deviations.end());
  return *limit / kSigmasLarger;
}

Drift driftOf(std::span<const double> values) {
  Drift drift;
  double lowest = values.front(), highest = values.front();
  for (const double value : values) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    drift.rise = std::max(drift.rise, value - lowest);
    drift.fall = std::max(drift.fall, highest - value);
  }
  drift.range = highest - lowest;
  drift.change = values.back() - values.front();
  return drift;
}

}  // namespace rotatebook::timeline
