#include "system/pool.h"

#include <atomic>
#include <chrono>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::system {
namespace {

std::vector<int> pattern() {
  return {1, 2, 3};
}
using VectorPool = Pool<std::vector<int>>;

TEST(Pool, LendsPicturesLikeThePattern) {
  VectorPool pool(pattern, 1);
  EXPECT_EQ(*pool.take(), pattern());
}

TEST(Pool, LendsEachPictureToOneAtATime) {
  VectorPool pool(pattern, 3);
  const auto a = pool.take(), b = pool.take(), c = pool.take();
  EXPECT_EQ((std::set{a.get(), b.get(), c.get()}).size(), 3U);
}

TEST(Pool, LendsThemAgainAndMakesNoNewOnes) {
  VectorPool pool(pattern, 2);
  std::set<const std::vector<int>*> seen;
  for (int i = 0; i < 100; ++i) seen.insert(pool.take().get());
  const auto held = pool.take();
  for (int i = 0; i < 100; ++i) seen.insert(pool.take().get());
  EXPECT_LE(seen.size(), 2U);
}

TEST(Pool, TakesAPictureBackFromItsLastOwnerOnly) {
  VectorPool pool(pattern, 2);
  auto first = pool.take();
  const std::vector<int>* const lent = first.get();
  auto shared = first;
  first.reset();
  EXPECT_NE(pool.take().get(), lent) << "somebody still has it";
  shared.reset();
  const auto a = pool.take(), b = pool.take();
  EXPECT_TRUE(a.get() == lent || b.get() == lent);
}

TEST(Pool, WaitsUntilAPictureIsFree) {
  VectorPool pool(pattern, 1);
  auto held = pool.take();
  std::atomic<bool> given = false;
  bool givenWhenTaken = false;
  std::thread waiting([&] {
    const auto picture = pool.take();
    givenWhenTaken = given;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  given = true;
  held.reset();
  waiting.join();
  EXPECT_TRUE(givenWhenTaken);
}

TEST(Pool, GoesRoundAmongThreads) {
  constexpr int kThreads = 4;
  constexpr int kTurns = 2000;
  VectorPool pool(pattern, 2);
  std::atomic<int> lent = 0, mostLent = 0, turns = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      for (int turn = 0; turn < kTurns; ++turn) {
        const auto picture = pool.take();
        const int now = ++lent;
        if (now > mostLent) mostLent = now;
        (*picture)[0] = i;  // Nobody else may be writing it.
        ++turns;
        --lent;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(turns, kThreads * kTurns);
  EXPECT_LE(mostLent, 2);
}

}  // namespace
}  // namespace rotatebook::system
