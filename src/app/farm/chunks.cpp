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

std::int64_t countTasks(const DividedClips& clips) {
  return sumOf(clips.parts) - std::ranges::count(clips.startsTask, false);
}

/// Puts whole clips into tasks: another one where a clip's time no longer fits into the last.
DividedClips grouped(const std::vector<std::int64_t>& parts, const std::vector<double>& times,
                     double limit) {
  DividedClips clips{parts, {}};
  double filled = limit;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    clips.startsTask.push_back(parts[i] > 1 || filled + times[i] > limit);
    if (parts[i] == 1) filled = clips.startsTask[i] ? times[i] : filled + times[i];
  }
  return clips;
}

/// Divides clips by a number of units.
DividedClips clipsOfChunk(const std::vector<Effort>& efforts, std::int64_t chunk, bool mayBeCut) {
  const std::vector<std::int64_t> parts =
      mayBeCut ? partsOfSize(efforts, chunk) : std::vector<std::int64_t>(efforts.size(), 1);
  std::vector<double> units;
  for (const Effort& effort : efforts) units.push_back(static_cast<double>(effort.units));
  return grouped(parts, units, static_cast<double>(chunk));
}

/// Throws InputError that names the smallest chunk if that one makes too many tasks.
template <typename CountTasks>
void requireFewTasks(const std::vector<Effort>& efforts, std::int64_t chunk, const Slots& slots,
                     const CountTasks& countOf) {
  const auto fitsWith = [&](std::int64_t one) {
    return slots.maxTasks == 0 || countOf(one) <= slots.maxTasks;
  };
  if (fitsWith(chunk)) return;
  std::int64_t tooSmall = chunk, large = chunk;
  for (const Effort& effort : efforts) large += effort.units;
  while (large - tooSmall > 1) {
    const std::int64_t middle = tooSmall + (large - tooSmall) / 2;
    (fitsWith(middle) ? large : tooSmall) = middle;
  }
  throw InputError(fmt::format(
      "--chunk {} makes {} tasks; the cluster takes at most {} at once: take --chunk {} or more",
      chunk, countOf(chunk), slots.maxTasks, large));
}

}  // namespace

DividedClips divideClips(const std::vector<Effort>& efforts, std::int64_t chunk, const Slots& slots,
                         bool mayBeCut) {
  if (chunk > 0) {
    const auto divided = [&](std::int64_t one) { return clipsOfChunk(efforts, one, mayBeCut); };
    requireFewTasks(efforts, chunk, slots, [&](auto one) { return countTasks(divided(one)); });
    return divided(chunk);
  }
  const std::vector<double> seconds = taskTimes(efforts, slots, kStartsInATask);
  std::vector<double> times;
  for (const Effort& effort : efforts) times.push_back(secondsOf(effort));
  const double limit = std::ranges::max(taskTimes(efforts, slots, kStartsInATaskOfWholes));
  for (double longer = 1;; longer *= kLonger) {
    std::vector<std::int64_t> parts(efforts.size(), 1);
    for (std::size_t i = 0; mayBeCut && i < efforts.size(); ++i)
      parts[i] = partsOfLength(efforts[i], longer * seconds[i]);
    const DividedClips clips = grouped(parts, times, longer * limit);
    if (slots.maxTasks == 0 || countTasks(clips) <= slots.maxTasks) return clips;
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
  const auto divided = [&](std::int64_t one) { return partsOfSize(efforts, one); };
  requireFewTasks(efforts, chunk, slots, [&](auto one) { return sumOf(divided(one)); });
  return divided(chunk);
}

}  // namespace rotatebook::farm
