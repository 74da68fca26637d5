// The resources of the machine.
#pragma once

#include <algorithm>
#include <thread>
#include <unistd.h>

namespace rotatebook::system {

/// Returns the number of the machine's cores, at least 1.
inline int coreCount() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Returns the machine's memory. [bytes]
inline double memorySize() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace rotatebook::system
