// The number of parts into which work is best divided.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rotatebook::farm {

/// A scene's work, as it was measured.
struct Effort {
  std::string name;        ///< For messages.
  std::int64_t units = 1;  ///< Frames or tiles, >= 1.
  double unit = 0;         ///< Time of one on a task's cores, > 0. [s]
  double start = 0;        ///< Time of a task before its first unit. [s]
};

/// The machines, as far as they are known.
struct Slots {
  std::int64_t atATime = 0;   ///< Tasks that run at the same time; 0 if that isn't known.
  std::int64_t maxTasks = 0;  ///< Most tasks that may be sent at once; 0 for any number.
};

/// Returns the number of parts of each scene. A task takes a third of what all work would take on
/// all slots, so that these end together; but at least 20 times its start, which then costs at most
/// 5 %, and at most five minutes, which is what a failure may lose. Tasks are longer if there would
/// be more than `maxTasks`. Throws InputError if there are more scenes than that.
std::vector<std::int64_t> partsOf(const std::vector<Effort>& efforts, const Slots& slots);

/// Clips, divided into tasks.
struct DividedClips {
  std::vector<std::int64_t> parts;  ///< Of each; 1 of those that stay whole.
  std::vector<bool> startsTask;     ///< False of a whole one that the task before takes, too.
};

/// Divides clips as partsOf(), or into parts of `chunk` units if that isn't 0. Those that are
/// shorter, or all if none `mayBeCut`, stay whole, several in a task of at least 40 starts, or of
/// `chunk` units together. Throws InputError that names the smallest chunk if there are too many.
DividedClips divideClips(const std::vector<Effort>& efforts, std::int64_t chunk, const Slots& slots,
                         bool mayBeCut);

/// Returns the number of parts of each scene if each has `chunk` units, or fewer. Throws InputError
/// that names the smallest chunk if there are too many.
std::vector<std::int64_t> partsOfChunk(const std::vector<Effort>& efforts, std::int64_t chunk,
                                       const Slots& slots);

}  // namespace rotatebook::farm
