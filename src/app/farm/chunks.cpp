#include "farm/chunks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

#include "base/error.h"

namespace rotatebook::farm {
namespace {

constexpr double kRounds = 3;          ///< Tasks after each other on a slot.
constexpr double kStartsInATask = 20;  ///< A start costs a twentieth.
/// Of whole clips, which lose little if a task fails. [starts]
constexpr double kStartsInATaskOfWholes = 40;
constexpr double kLongestTask = 300;  ///< [s]
constexpr double kLonger = 1.1;       ///< Tasks are made longer by this until they fit.

std::int64_t ceilOf(std::int64_t units, std::int64_t chunk) {
  return units / chunk + (units % chunk != 0 ? 1 : 0);
}

std::int64_t sumOf(const std::vector<std::int64_t>& parts) {
  return std::accumulate(parts.begin(), parts.end(), std::int64_t{0});
}

bool fits(const std::vector<std::int64_t>& parts, const Slots& slots) {
  return slots.maxTasks == 0 || sumOf(parts) <= slots.maxTasks;
}

void requireFewScenes(const std::vector<Effort>& efforts, const Slots& slots) {
  if (slots.maxTasks == 0 || std::ssize(efforts) <= slots.maxTasks) return;
  throw InputError(
      fmt::format("the cluster takes at most {} tasks at once, fewer than the {} scenes; submit "
                  "some of them at a time",
                  slots.maxTasks, efforts.size()));
}

/// Returns the number of parts of tasks that take about `seconds`.
std::int64_t partsOfLength(const Effort& effort, double seconds) {
  const double chunk = std::clamp(std::ceil(seconds / effort.unit), 1.0, double(effort.units));
  return ceilOf(effort.units, static_cast<std::int64_t>(chunk));
}

std::vector<std::int64_t> partsOfSize(const std::vector<Effort>& efforts, std::int64_t chunk) {
  std::vector<std::int64_t> parts;
  for (const Effort& effort : efforts) parts.push_back(ceilOf(effort.units, chunk));
  return parts;
}

double secondsOf(const Effort& effort) {
  return static_cast<double>(effort.units) * effort.unit;
}

/// Returns the best time of each scene's tasks, at least so many `starts`. [s]
std::vector<double> taskTimes(const std::vector<Effort>& efforts, const Slots& slots,
                              double starts) {
  double all = 0;
  for (const Effort& effort : efforts) all += secondsOf(effort);
  const double level = slots.atATime > 0 ? all / (kRounds * double(slots.atATime)) : 0;
  std::vector<double> seconds;
  for (const Effort& effort : efforts)
    seconds.push_back(
        std::max(std::min(level, kLongestTask), std::min(starts * effort.start, kLongestTask)));
  return seconds;
}

/// Starts a task where a scene's time no longer fits into the one before.
std::vector<bool> grouped(const std::vector<double>& times, double limit) {
  std::vector<bool> starts;
  double filled = 0;
  for (const double time : times) {
    starts.push_back(starts.empty() || filled + time > limit);
    filled = starts.back() ? time : filled + time;
  }
  return starts;
}

}  // namespace

std::vector<bool> tasksOfWholes(const std::vector<Effort>& efforts, std::int64_t chunk,
                                const Slots& slots) {
  std::vector<double> times;
  for (const Effort& effort : efforts)
    times.push_back(chunk > 0 ? static_cast<double>(effort.units) : secondsOf(effort));
  double limit = chunk > 0 ? static_cast<double>(chunk)
                           : std::ranges::max(taskTimes(efforts, slots, kStartsInATaskOfWholes));
  for (;; limit *= kLonger) {
    const std::vector<bool> starts = grouped(times, limit);
    const auto tasks = std::ranges::count(starts, true);
    if (slots.maxTasks == 0 || tasks <= slots.maxTasks) return starts;
    if (chunk > 0) {
      throw InputError(
          fmt::format("--chunk {} makes {} tasks; the cluster takes at most {} at once", chunk,
                      tasks, slots.maxTasks));
    }
  }
}

std::vector<std::int64_t> partsOf(const std::vector<Effort>& efforts, const Slots& slots) {
  requireFewScenes(efforts, slots);
  std::vector<double> seconds = taskTimes(efforts, slots, kStartsInATask);
  for (;;) {
    std::vector<std::int64_t> parts;
    for (std::size_t i = 0; i < efforts.size(); ++i)
      parts.push_back(partsOfLength(efforts[i], seconds[i]));
    if (fits(parts, slots)) return parts;
    for (double& one : seconds) one = std::max(one * kLonger, 1e-3);
  }
}

std::vector<std::int64_t> partsOfChunk(const std::vector<Effort>& efforts, std::int64_t chunk,
                                       const Slots& slots) {
  requireFewScenes(efforts, slots);
  std::vector<std::int64_t> parts = partsOfSize(efforts, chunk);
  if (fits(parts, slots)) return parts;
  std::int64_t tooSmall = chunk;
  std::int64_t large = std::ranges::max(efforts, {}, &Effort::units).units;
  while (large - tooSmall > 1) {
    const std::int64_t middle = tooSmall + (large - tooSmall) / 2;
    (fits(partsOfSize(efforts, middle), slots) ? large : tooSmall) = middle;
  }
  throw InputError(fmt::format(
      "--chunk {} makes {} tasks; the cluster takes at most {} at once: take --chunk {} or more",
      chunk, sumOf(parts), slots.maxTasks, large));
}

}  // namespace rotatebook::farm
