#include "recording/gaps.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "base/number_text.h"
#include "recording/inertial_recording.h"

namespace rotatebook::recording {
namespace {

constexpr double kShortestGap = 4;  // [usual steps]

/// Returns the slope of the rates from reading `index` to the next; 0 beyond the ends.
Eigen::Vector3d slopeAfter(const std::vector<Rate>& rates, std::size_t index) {
  if (index + 1 >= rates.size()) return Eigen::Vector3d::Zero();
  const Rate &here = rates[index], &next = rates[index + 1];
  return (next.angularVelocity - here.angularVelocity) / (next.time - here.time);
}

/// Returns an estimate of the error of the turn in the gap after reading `index`. [rad]
double errorInGap(const std::vector<Rate>& rates, std::size_t index) {
  const double h = rates[index + 1].time - rates[index].time;
  const Eigen::Vector3d before = index > 0 ? slopeAfter(rates, index - 1) : Eigen::Vector3d::Zero();
  const Eigen::Vector3d after = slopeAfter(rates, index + 1);
  const Eigen::Vector3d sum = rates[index].angularVelocity + rates[index + 1].angularVelocity;
  const Eigen::Vector3d cubic = h / 2 * sum + h * h / 12 * (before - after);
  return (cubic - meanTurnInGap(rates, index)).norm();
}

/// Returns the usual step of at least two readings. [s]
double usualStep(const std::vector<Rate>& rates) {
  std::vector<double> times;
  for (const Rate& rate : rates) times.push_back(rate.time);
  return medianStep(times);
}

std::string degreesText(double angle) {
  return roundedText(angle * 180 / std::numbers::pi, 2) + " degrees";
}

}  // namespace

double medianStep(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

std::string gapNote(const std::vector<Rate>& rates, double zero, bool areIntegrated) {
  if (rates.size() < 3) return "";
  const double usual = usualStep(rates);
  std::size_t count = 0, longest = 0;
  double length = 0, error = 0;
  for (std::size_t i = 0; i + 1 < rates.size(); ++i) {
    const double step = rates[i + 1].time - rates[i].time;
    if (step < kShortestGap * usual) continue;
    ++count;
    error += errorInGap(rates, i);
    if (step > length) longest = i;
    length = std::max(length, step);
  }
  if (count == 0) return "";
  const std::string gaps =
      count == 1 ? "a gap of " : std::to_string(count) + " gaps, the longest of ";
  const std::string cost =
      areIntegrated ? ", and the attitude after may be off by " + degreesText(error) : "";
  return gaps + roundedText(length, 3) + " s from " + timeText(zero + rates[longest].time) +
         " s on, where readings are usually " + roundedText(usual, 3) +
         " s apart: what was between isn't known" + cost;
}

double unknownTurnIn(const std::vector<Rate>& rates) {
  constexpr double kShort = 0.3;  // turn in which a cubic is near [rad]
  if (rates.size() < 3) return 0;
  const double usual = usualStep(rates);
  double error = 0;
  for (std::size_t i = 0; i + 1 < rates.size(); ++i) {
    const double step = rates[i + 1].time - rates[i].time;
    const double rate =
        std::max(rates[i].angularVelocity.norm(), rates[i + 1].angularVelocity.norm());
    if (step >= kShortestGap * usual || step * rate > kShort) error += errorInGap(rates, i);
  }
  return error;
}

std::vector<std::size_t> breaksIn(const std::vector<Rate>& rates) {
  constexpr double kLargestTurn = 0.5;  // [rad]
  std::vector<std::size_t> breaks;
  if (rates.size() < 3) return breaks;
  const double shortest = kShortestGap * usualStep(rates);
  for (std::size_t i = 1; i < rates.size(); ++i) {
    const Rate &before = rates[i - 1], &here = rates[i];
    const double step = here.time - before.time;
    const double rate = std::max(before.angularVelocity.norm(), here.angularVelocity.norm());
    if (step >= shortest && step * rate > kLargestTurn) breaks.push_back(i);
  }
  return breaks;
}

}  // namespace rotatebook::recording
