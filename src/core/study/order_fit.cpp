#include "study/order_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/elementary.h"

namespace rotatebook::study {
namespace {

using Runs = std::vector<ErrorAtStep>;

double slopeBetween(const ErrorAtStep& a, const ErrorAtStep& b) {
  return logarithm(b.errorDeg / a.errorDeg) / logarithm(b.h / a.h);
}

// Returns the runs by step, shortest first, without errors of 0, up to the first saturated one.
Runs unsaturated(std::span<const ErrorAtStep> all) {
  Runs runs(all.begin(), all.end());
  std::ranges::sort(runs, {}, &ErrorAtStep::h);
  std::erase_if(runs, [](const ErrorAtStep& run) { return run.errorDeg == 0; });
  // NaN, which can't be fitted, compares false.
  const auto saturated = std::ranges::find_if_not(
      runs, [](const ErrorAtStep& run) { return run.errorDeg <= kLargestErrorDeg; });
  runs.erase(saturated, runs.end());
  return runs;
}

bool flattens(const Runs& runs) {
  double steepest = 0;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    steepest = std::max(steepest, slopeBetween(runs[i - 1], runs[i]));
  }
  return runs.size() > 1 && slopeBetween(runs[0], runs[1]) < steepest / 2;
}

void removeFloor(Runs& runs) {
  const auto smallest = std::ranges::min_element(runs, {}, &ErrorAtStep::errorDeg);
  const bool grows = smallest != runs.begin();
  runs.erase(runs.begin(), smallest);
  if (runs.empty() || !(grows || flattens(runs))) return;
  const double least = kFloorMargin * runs.front().errorDeg;
  std::erase_if(runs, [least](const ErrorAtStep& run) { return run.errorDeg < least; });
}

double leastSquaresSlope(const Runs& runs) {
  const auto count = static_cast<double>(runs.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const ErrorAtStep& run : runs) {
    // Relative to the first run, to avoid cancellation.
    const double u = logarithm(run.h / runs.front().h);
    const double v = logarithm(run.errorDeg / runs.front().errorDeg);
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  return (count * xy - x * y) / (count * xx - x * x);
}

}  // namespace

OrderFit fitOrder(std::span<const ErrorAtStep> all) {
  Runs runs = unsaturated(all);
  removeFloor(runs);
  OrderFit fit;
  if (runs.empty()) return fit;
  fit.runs = static_cast<int>(runs.size());
  fit.shortest = runs.front().h;
  fit.longest = runs.back().h;
  if (fit.runs >= kMinRuns) fit.order = leastSquaresSlope(runs);
  return fit;
}

}  // namespace rotatebook::study
