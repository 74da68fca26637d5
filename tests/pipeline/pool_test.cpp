#include "pipeline/pool.h"

#include <atomic>
#include <chrono>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::pipeline {
namespace {

const image::Image kPattern(4, 2, image::PixelFormat::Rgba8);

TEST(PicturePool, LendsPicturesLikeThePattern) {
  PicturePool pool(kPattern, 1);
  EXPECT_EQ(*pool.take(), kPattern);
}

TEST(PicturePool, LendsEachPictureToOneAtATime) {
  PicturePool pool(kPattern, 3);
  const auto a = pool.take(), b = pool.take(), c = pool.take();
  EXPECT_EQ((std::set{a.get(), b.get(), c.get()}).size(), 3U);
}

TEST(PicturePool, LendsThemAgainAndMakesNoNewOnes) {
  PicturePool pool(kPattern, 2);
  std::set<const image::Image*> seen;
  for (int i = 0; i < 100; ++i) seen.insert(pool.take().get());
  const auto held = pool.take();
  for (int i = 0; i < 100; ++i) seen.insert(pool.take().get());
  EXPECT_LE(seen.size(), 2U);
}

TEST(PicturePool, TakesAPictureBackFromItsLastOwnerOnly) {
  PicturePool pool(kPattern, 2);
  auto first = pool.take();
  const image::Image* const lent = first.get();
  auto shared = first;
  first.reset();
  EXPECT_NE(pool.take().get(), lent) << "somebody still has it";
  shared.reset();
  const auto a = pool.take(), b = pool.take();
  EXPECT_TRUE(a.get() == lent || b.get() == lent);
}

TEST(PicturePool, WaitsUntilAPictureIsFree) {
  PicturePool pool(kPattern, 1);
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

TEST(PicturePool, GoesRoundAmongThreads) {
  constexpr int kThreads = 4;
  constexpr int kTurns = 2000;
  PicturePool pool(kPattern, 2);
  std::atomic<int> lent = 0, mostLent = 0, turns = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      for (int turn = 0; turn < kTurns; ++turn) {
        const auto picture = pool.take();
        const int now = ++lent;
        if (now > mostLent) mostLent = now;
        picture->row(0)[0] = static_cast<std::uint8_t>(i);  // Nobody else may be writing it.
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
}  // namespace rotatebook::pipeline
