#include "system/resource_limits.h"

#include <string>
#include <sys/resource.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "base/error.h"
#include "system/child_process.h"

namespace rotatebook {
namespace {

TEST(ResourceLimits, OfMemoryAreListedIfTheyAreLow) {
  const auto listed = [] {
    const rlimit low{200'000 << 10, 200'000 << 10};
    setrlimit(RLIMIT_DATA, &low);
    const std::vector<std::string> limits = system::memoryLimits();
    _exit(limits.empty() || limits[0] != "ulimit -d (it is 200000 kB)" ? 1 : 2);
  };
  EXPECT_EQ(system::ChildProcess::copy(listed).wait().status, 2);
}

TEST(ResourceLimits, OfTheStackAreRefusedIfTheyAreLow) {
  EXPECT_NO_THROW(system::requireStack());
  const auto refused = [] {
    const rlimit low{200 << 10, 200 << 10};
    setrlimit(RLIMIT_STACK, &low);
    try {
      system::requireStack();
    } catch (const MachineError& error) {
      _exit(std::string(error.what()).starts_with("the stack is limited to 200 kB") ? 3 : 1);
    }
  };
  EXPECT_EQ(system::ChildProcess::copy(refused).wait().status, 3);
}

}  // namespace
}  // namespace rotatebook
