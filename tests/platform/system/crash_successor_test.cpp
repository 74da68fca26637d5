#include "system/crash_successor.h"

#include <csignal>
#include <filesystem>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "system/child_process.h"

namespace rotatebook {
namespace {

extern "C" void onTestCrash(int signal) {
  system::becomeCrashSuccessor(signal);
  _exit(9);  // There was no successor.
}

/// Returns how a process ends that crashes with this successor, a run of this test program.
system::ProcessEnd endOf(const std::vector<std::string>& successor) {
  return system::ChildProcess::copy([&] {
           std::signal(SIGSEGV, onTestCrash);
           if (!successor.empty()) system::setCrashSuccessor(successor);
           raise(SIGSEGV);
         })
      .wait();
}

TEST(CrashSuccessor, TakesThePlaceOfAProcessThatCrashes) {
  // The last argument, the signal, is one that GoogleTest ignores.
  EXPECT_EQ(endOf({"tests", "--gtest_list_tests", "--gtest_filter=none"}).status, 0);
}

TEST(CrashSuccessor, IsntThereUnlessItWasSet) {
  EXPECT_EQ(endOf({}).status, 9);
}

}  // namespace
}  // namespace rotatebook
