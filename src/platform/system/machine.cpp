#include "system/machine.h"

#include <algorithm>
#include <cmath>
#include <sched.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "system/control_groups.h"

namespace rotatebook::system {
namespace {

/// Returns the number of cores in this process's affinity; all of the machine's if it is unknown.
int affineCores() {
  constexpr std::size_t kMaxCores = 1 << 16;
  std::vector<cpu_set_t> set(CPU_ALLOC_SIZE(kMaxCores) / sizeof(cpu_set_t));
  const std::size_t size = set.size() * sizeof(cpu_set_t);
  if (sched_getaffinity(0, size, set.data()) == 0) return CPU_COUNT_S(size, set.data());
  return static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

int coreCount() {
  const int cores = std::max(1, affineCores());
  const auto quota = controlGroupLimits().cores;
  return quota ? std::clamp(static_cast<int>(std::ceil(std::min(*quota, 1.0 * cores))), 1, cores)
               : cores;
}

int rendersFor(int cores) {
  // Eight clips on two cores take 46 s two at a time, 52 s one after the other
  constexpr int kCoresARender = 3;
  return std::max(cores / kCoresARender, std::min(cores, 2));
}

double memorySize() {
  const double size =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::min(size, controlGroupLimits().memory.value_or(size));
}

}  // namespace rotatebook::system
