// The resources of the machine that this process may use.
#pragma once

namespace rotatebook::system {

/// Returns the number of cores, at least 1, that this process may use: of those that taskset or a
/// batch system left it (its affinity), as many as the quota of its control groups allows, rounded
/// up.
int coreCount();

/// Returns how many renders share so many cores best: one for every three, but two of as few as
/// two.
int rendersFor(int cores);

/// Returns the memory that this process may use: the machine's, or the limit of its control groups
/// if that is lower. [bytes]
double memorySize();

}  // namespace rotatebook::system
