#include "system/parallel_runs.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rotatebook::system {
namespace {

using ::testing::AllOf;
using ::testing::Ge;
using ::testing::Le;

std::vector<std::size_t> upTo(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

class ParallelRuns : public ::testing::TestWithParam<int> {};

TEST_P(ParallelRuns, MakesEachOnce) {
  std::vector<std::atomic<int>> made(100);
  const bool all = runParallel(upTo(100), [&](std::size_t i) { ++made[i]; }, {GetParam()});
  EXPECT_TRUE(all);
  for (const auto& count : made) EXPECT_EQ(count, 1);
}

TEST_P(ParallelRuns, ReportTheirProgress) {
  std::vector<std::size_t> heard;
  RunOptions options{GetParam()};
  const auto caller = std::this_thread::get_id();
  options.progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 20U);
    EXPECT_EQ(std::this_thread::get_id(), caller);
    heard.push_back(done);
  };
  runParallel(
      upTo(20), [](std::size_t) {}, options);
  EXPECT_TRUE(std::ranges::is_sorted(heard));
  EXPECT_EQ(heard.back(), 20U);
}

TEST_P(ParallelRuns, EndWithTheFirstError) {
  std::atomic<int> made = 0;
  const auto run = [&](std::size_t i) {
    ++made;
    if (i == 3) throw std::runtime_error("run 3");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  EXPECT_THROW(runParallel(upTo(1000), run, {GetParam()}), std::runtime_error);
  EXPECT_LT(made, 500);
}

TEST_P(ParallelRuns, EndEarlyAfterAStop) {
  std::atomic<bool> stop = false;
  std::atomic<int> made = 0;
  RunOptions options{GetParam(), &stop};
  EXPECT_FALSE(runParallel(
      upTo(1000),
      [&](std::size_t i) {
        ++made;
        if (i == 5) stop = true;
      },
      options));
  EXPECT_THAT(made.load(), AllOf(Ge(6), Le(5 + 8)));
}

TEST_P(ParallelRuns, AreDoneAtOnceIfThereAreNone) {
  EXPECT_TRUE(runParallel({}, [](std::size_t) { FAIL(); }, {GetParam()}));
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelRuns, ::testing::Values(0, 1, 2, 8));

TEST(ParallelRuns, AreTakenInTheirOrder) {
  std::vector<std::size_t> order;
  const std::vector<std::size_t> indices{5, 1, 3};
  runParallel(indices, [&](std::size_t i) { order.push_back(i); }, {1});
  EXPECT_EQ(order, indices);
}

TEST(ParallelRuns, GoOnAtATime) {
  // Each waits for the other: one thread alone would never end.
  std::atomic<int> begun = 0;
  runParallel(upTo(2),
              [&](std::size_t) {
                ++begun;
                while (begun < 2) std::this_thread::yield();
              },
              {2});
  EXPECT_EQ(begun, 2);
}

}  // namespace
}  // namespace rotatebook::system
