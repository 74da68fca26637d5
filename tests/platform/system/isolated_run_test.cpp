#include "system/isolated_run.h"

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <unistd.h>

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

using std::chrono::seconds;

TEST(IsolatedRun, ReportsNothingIfTheActionReturns) {
  EXPECT_EQ(system::runIsolated([] { std::cerr << "a warning\n"; }, seconds(60)), "");
  EXPECT_EQ(system::runIsolated([] { throw std::runtime_error("told later"); }, seconds(60)), "");
}

TEST(IsolatedRun, ChangesNothingHere) {
  int value = 1;
  system::runIsolated([&] { value = 2; }, seconds(60));
  EXPECT_EQ(value, 1);
}

TEST(IsolatedRun, NamesWhatEndsTheProcess) {
  EXPECT_EQ(system::runIsolated([] { raise(SIGKILL); }, seconds(60)), "ends the process (Killed)");
  EXPECT_EQ(system::runIsolated([] { _exit(7); }, seconds(60)), "ends the process (exit status 7)");
}

TEST(IsolatedRun, ReportsTheLastLine) {
  const auto fail = [] {
    std::cerr << "first line\nassertion failed\n";
    raise(SIGKILL);
  };
  EXPECT_EQ(system::runIsolated(fail, seconds(60)), "ends the process (Killed): assertion failed");
}

TEST(IsolatedRun, EndsWhatDoesNotReturn) {
  EXPECT_EQ(system::runIsolated([] { pause(); }, seconds(1)), "doesn't return within 1 s");
}

}  // namespace
}  // namespace rotatebook
