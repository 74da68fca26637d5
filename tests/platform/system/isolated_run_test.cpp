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

TEST(Trial, SaysNothingOfWhatComesBack) {
  EXPECT_EQ(system::runIsolated([] { std::cerr << "a warning\n"; }, seconds(60)), "");
  EXPECT_EQ(system::runIsolated([] { throw std::runtime_error("told later"); }, seconds(60)), "");
}

TEST(Trial, ChangesNothingHere) {
  int value = 1;
  system::runIsolated([&] { value = 2; }, seconds(60));
  EXPECT_EQ(value, 1);
}

TEST(Trial, TellsWhatEndsTheProcess) {
  EXPECT_EQ(system::runIsolated([] { raise(SIGKILL); }, seconds(60)), "ends the process (Killed)");
  EXPECT_EQ(system::runIsolated([] { _exit(7); }, seconds(60)), "ends the process (exit status 7)");
}

TEST(Trial, TellsTheLastWords) {
  const auto fail = [] {
    std::cerr << "first line\nassertion failed\n";
    raise(SIGKILL);
  };
  EXPECT_EQ(system::runIsolated(fail, seconds(60)), "ends the process (Killed): assertion failed");
}

TEST(Trial, EndsWhatDoesNotComeBack) {
  EXPECT_EQ(system::runIsolated([] { pause(); }, seconds(1)), "doesn't come back within 1 s");
}

}  // namespace
}  // namespace rotatebook
