#include "farm/chunks.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"

namespace rotatebook::farm {
namespace {

using ::testing::ElementsAre;

// 20,000 frames of 15 ms on one core: 300 s of work.
const Effort kClip{"clip", 20'000, 0.015, 0.6};

std::string messageOf(const std::vector<Effort>& efforts, std::int64_t chunk, const Slots& slots) {
  try {
    partsOfChunk(efforts, chunk, slots);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Chunks, HaveAThirdOfASlotsShare) {
  // 300 s on 4 slots: 25 s, 1667 frames.
  EXPECT_THAT(partsOf({kClip}, {4, 1000}), ElementsAre(12));
}

TEST(Chunks, TakeAtLeastTwentyTimesTheirStart) {
  // Not 1 s on 100 slots, but 12 s: 800 frames.
  EXPECT_THAT(partsOf({kClip}, {100, 1000}), ElementsAre(25));
  EXPECT_THAT(partsOf({kClip}, {0, 0}), ElementsAre(25)) << "slots unknown";
  EXPECT_THAT(partsOf({{"short", 240, 0.005, 0.6}}, {4, 1000}), ElementsAre(1));
}

TEST(Chunks, TakeAtMostFiveMinutes) {
  // 2,000,000 frames on 4 slots would be 2500 s each.
  EXPECT_THAT(partsOf({{"film", 2'000'000, 0.015, 0.6}}, {4, 1000}), ElementsAre(100));
  // A start of a minute doesn't make tasks of 20 minutes.
  EXPECT_THAT(partsOf({{"long", 200'000, 0.015, 60}}, {4, 1000}), ElementsAre(10));
}

TEST(Chunks, GrowUntilTheClusterTakesThem) {
  const std::vector<std::int64_t> parts = partsOf({{"film", 2'000'000, 0.15, 0.6}}, {4, 500});
  EXPECT_LE(parts[0], 500);  // 1000 of five minutes
  EXPECT_GE(parts[0], 450);  // no more than a tenth longer than they have to be
}

TEST(Chunks, AreSharedBetweenScenes) {
  const std::vector<std::int64_t> parts = partsOf({kClip, {"other", 10'000, 0.03, 0.6}}, {4, 1000});
  EXPECT_THAT(parts, ElementsAre(6, 6));  // 50 s each: 3334 and 1667 frames
  EXPECT_THROW(partsOf({kClip, kClip, kClip}, {4, 2}), InputError);
}

// 3.6 s; a task takes at least 24 s of whole ones, forty times its start.
const Effort kShort{"short", 240, 0.015, 0.6};

TEST(Chunks, TakeSeveralShortClips) {
  constexpr bool kWhole = false;
  const std::vector<Effort> seven(7, kShort);
  const auto starts = [&](std::int64_t chunk, const Slots& slots) {
    return divideClips(seven, chunk, slots, kWhole).startsTask;
  };
  EXPECT_THAT(starts(0, {}), ElementsAre(true, false, false, false, false, false, true));
  EXPECT_THAT(starts(500, {}), ElementsAre(true, false, true, false, true, false, true));
  EXPECT_THAT(starts(1, {}), ::testing::Each(true));
  const auto fewer = starts(0, {.atATime = 0, .maxTasks = 1});
  EXPECT_EQ(std::ranges::count(fewer, true), 1);
  EXPECT_THROW(starts(500, {.atATime = 0, .maxTasks = 2}), InputError);
  EXPECT_NO_THROW(starts(960, {.atATime = 0, .maxTasks = 2}));
  EXPECT_THAT(divideClips({kShort, kClip}, 0, {}, kWhole).parts, ElementsAre(1, 1));
}

TEST(Chunks, CutLongClipsAmongShortOnes) {
  const std::vector<Effort> mixed{kShort, kClip, kShort};
  const DividedClips clips = divideClips(mixed, 0, {}, true);
  EXPECT_THAT(clips.parts, ElementsAre(1, 25, 1));
  EXPECT_THAT(clips.startsTask, ElementsAre(true, true, false)) << "both short ones in one task";
  const DividedClips given = divideClips(mixed, 400, {}, true);
  EXPECT_THAT(given.parts, ElementsAre(1, 50, 1));
  EXPECT_THAT(given.startsTask, ElementsAre(true, true, true)) << "480 frames";
  EXPECT_EQ(divideClips(mixed, 0, {.atATime = 0, .maxTasks = 10}, true).parts[1], 9);
  // More scenes than tasks, as they are short
  EXPECT_NO_THROW(divideClips({kShort, kShort, kShort}, 0, {.atATime = 0, .maxTasks = 2}, true));
}

TEST(Chunks, HaveAtLeastOneUnit) {
  EXPECT_THAT(partsOf({{"slow", 3, 4000, 0.6}}, {1, 1000}), ElementsAre(3));
}

TEST(Chunks, AreOfTheSizeThatTheUserGives) {
  EXPECT_THAT(partsOfChunk({kClip, {"other", 10, 1, 0}}, 100, {4, 1000}), ElementsAre(200, 1));
}

TEST(Chunks, ThatAreTooManyAreRefusedWithTheSmallestSize) {
  const std::vector<Effort> both{kClip, {"other", 1000, 1, 0}};
  EXPECT_MESSAGE(messageOf(both, 10, {4, 1000}));
  EXPECT_EQ(messageOf(both, 22, {4, 1000}), "");
  EXPECT_NE(messageOf(both, 20, {4, 1000}), "");
  EXPECT_EQ(messageOf(both, 1, {}), "") << "others than Slurm take any number";
}

}  // namespace
}  // namespace rotatebook::farm
