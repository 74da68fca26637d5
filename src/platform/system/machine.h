// What there is to share out.
#pragma once

#include <algorithm>
#include <thread>
#include <unistd.h>

namespace rotatebook::system {

/// The machine's cores, at least 1.
inline int coreCount() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// The machine's memory. [bytes]
inline double memorySize() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace rotatebook::system
