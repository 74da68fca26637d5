// Drawing into sinks that run beside it.
#include "pipeline/draw_frames.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/fake_sinks.h"
#include "pipeline/small_clip.h"

namespace rotatebook::pipeline {
namespace {

using namespace std::chrono_literals;
using testing::FakeSink;
using testing::numbers;
using testing::SinkFailure;

constexpr std::int64_t kMostInFlight = 8;
constexpr std::int64_t kMostExposed = 3;
constexpr std::int64_t kMany = 40;

class DrawFrames : public ::testing::Test {
 protected:
  std::int64_t draw(store::FrameRange range, const std::vector<SinkThreads>& sinks,
                    const std::function<void(RenderProgress)>& progress = {}) {
    return drawFrames(drawer_, {range, nullptr, &stop_}, sinks, progress).total();
  }

  std::string failureOf(const std::vector<SinkThreads>& sinks) {
    return testing::messageOf<SinkFailure>([&] { draw({0, kMany}, sinks); });
  }

  std::atomic<bool> stop_ = false;

 private:
  scene::Scene scene_ = testing::smallScene();
  timeline::ClipMotion motion_{{physics::simulate(scene_.motion(), kMany)}, scene_.clip.frameRate};
  picture::FrameDrawer drawer_{scene_, motion_};
};

TEST_F(DrawFrames, GivesEachSinkAllFramesInOrder) {
  FakeSink fast, slow("slow", -1, 1ms);
  EXPECT_EQ(draw({0, kMany}, {{fast, 1}, {slow, 1}}), kMany);
  EXPECT_EQ(fast.indices(), numbers(0, kMany));
  EXPECT_EQ(slow.indices(), numbers(0, kMany));
}

TEST_F(DrawFrames, GivesASinkWithThreadsEachFrameOnce) {
  FakeSink sink("sink", -1, 1ms);
  EXPECT_EQ(draw({0, kMany}, {{sink, 3}}), kMany);
  std::vector<std::int64_t> indices = sink.indices();
  std::sort(indices.begin(), indices.end());
  EXPECT_EQ(indices, numbers(0, kMany));
}

TEST_F(DrawFrames, DrawsOnlyTheRange) {
  FakeSink sink;
  EXPECT_EQ(draw({7, 11}, {{sink, 1}}), 4);
  EXPECT_EQ(sink.indices(), numbers(7, 11));
}

TEST_F(DrawFrames, LeavesFinishingToTheCaller) {
  FakeSink sink;
  draw({0, 3}, {{sink, 1}});
  EXPECT_FALSE(sink.finished());
}

TEST_F(DrawFrames, TellsItsProgressFromNoneToAll) {
  FakeSink sink;
  std::vector<std::int64_t> done;
  draw({2, 6}, {{sink, 1}}, [&](RenderProgress progress) {
    done.push_back(progress.done);
    EXPECT_EQ(progress.total, 4);
  });
  EXPECT_EQ(done, numbers(0, 5));
}

TEST_F(DrawFrames, KeepsTheNumberOfPicturesInFlight) {
  FakeSink sink("slow", -1, 3ms);
  std::int64_t most = 0;
  draw({0, kMany}, {{sink, 1}},
       [&](RenderProgress progress) { most = std::max(most, progress.done - sink.written()); });
  // A frame may be written and its picture back before it is counted, or the other way round.
  EXPECT_LE(most, kMostInFlight + kMostExposed + 1);
  EXPECT_GE(most, 2) << "the sink is waited for";
  EXPECT_LE(sink.pictures().size(), static_cast<std::size_t>(kMostInFlight));
}

TEST_F(DrawFrames, ThrowsTheErrorOfASink) {
  for (const std::int64_t failAt : {std::int64_t{0}, std::int64_t{17}, kMany - 1}) {
    FakeSink failing("failing", failAt), whole;
    EXPECT_EQ(failureOf({{whole, 1}, {failing, 1}}), "failing fails at " + std::to_string(failAt));
    EXPECT_EQ(failing.indices(), numbers(0, failAt));
  }
}

TEST_F(DrawFrames, StopsSoonAfterAnError) {
  FakeSink failing("failing", 3), whole;
  failureOf({{failing, 1}, {whole, 1}});
  EXPECT_LT(whole.written(), kMany);
}

TEST_F(DrawFrames, ThrowsTheFirstErrorOfTwoSinks) {
  FakeSink late("late", 30, 1ms), early("early", 1);
  EXPECT_EQ(failureOf({{late, 1}, {early, 1}}), "early fails at 1");
}

TEST_F(DrawFrames, ThrowsTheErrorOfOneThreadOfMany) {
  FakeSink failing("failing", 9, 1ms), slow("slow", -1, 2ms);
  EXPECT_EQ(failureOf({{failing, 3}, {slow, 1}}), "failing fails at 9");
}

TEST_F(DrawFrames, StopsAfterTheFrameInHand) {
  FakeSink sink;
  const std::int64_t drawn = draw({0, kMany}, {{sink, 1}}, [&](RenderProgress progress) {
    if (progress.done == 5) stop_ = true;
  });
  EXPECT_EQ(drawn, 5);
  EXPECT_EQ(sink.indices(), numbers(0, 5));
}

TEST_F(DrawFrames, DrawsNothingWhenStoppedBefore) {
  FakeSink sink;
  stop_ = true;
  EXPECT_EQ(draw({0, kMany}, {{sink, 1}}), 0);
  EXPECT_TRUE(sink.indices().empty());
}

}  // namespace
}  // namespace rotatebook::pipeline
