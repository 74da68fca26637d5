// What there is to share out among threads.
#pragma once

#include <algorithm>
#include <thread>

namespace rotatebook::pipeline {

/// The machine's cores, at least 1.
inline int coreCount() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace rotatebook::pipeline
