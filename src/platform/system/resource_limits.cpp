#include "system/resource_limits.h"

#include <array>
#include <sys/resource.h>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "system/machine.h"

namespace rotatebook::system {
namespace {

using Resource = decltype(RLIMIT_STACK);

/// Returns the limit, 2^54 kB or more if there is none. [kB]
rlim_t limitOf(Resource resource) {
  rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
  getrlimit(resource, &limit);
  return limit.rlim_cur / 1024;
}

}  // namespace

void requireStack() {
  // The keys of a scene may take toml++ so much: measured 640 to 1280, as it is compiled. [kB]
  constexpr rlim_t kNeeded = 2048;
  const rlim_t limit = limitOf(RLIMIT_STACK);
  if (limit >= kNeeded) return;
  throw MachineError(fmt::format(
      "the stack is limited to {} kB, and {} kB are needed: raise the limit, ulimit -s 8192", limit,
      kNeeded));
}

std::vector<std::string> memoryLimits() {
  constexpr std::array kLimits{std::pair{RLIMIT_DATA, "ulimit -d"},
                               std::pair{RLIMIT_AS, "ulimit -v"}};
  std::vector<std::string> lower;
  for (const auto& [resource, name] : kLimits) {
    const rlim_t limit = limitOf(resource);
    if (1024 * static_cast<double>(limit) >= memorySize()) continue;
    lower.push_back(fmt::format("{} (it is {} kB)", name, limit));
  }
  return lower;
}

}  // namespace rotatebook::system
