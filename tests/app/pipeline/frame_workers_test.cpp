#include "pipeline/frame_workers.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/fake_sinks.h"
#include "system/pool.h"

namespace rotatebook::pipeline {
namespace {

using namespace std::chrono_literals;
using testing::FakeSink;
using testing::numbers;
using testing::SinkFailure;

constexpr std::int64_t kWorkedFrames = 50;

// Sends frames through a pool of four pictures, each with its number in the first byte.
void submitAll(system::Pool<image::Image>& pool, const std::vector<FrameWorkers*>& workers) {
  for (std::int64_t index = 0; index < kWorkedFrames; ++index) {
    const auto picture = pool.take();
    picture->row(0)[0] = static_cast<std::uint8_t>(index);
    for (FrameWorkers* worker : workers) worker->submit({index, picture});
  }
}

struct FrameWorkersTest : ::testing::Test {
  std::string keptError() {
    try {
      error.rethrow();
      return "none";
    } catch (const SinkFailure& failure) {
      return failure.what();
    }
  }

  system::FirstError error;
  system::Pool<image::Image> pool{[] { return image::Image(4, 2, image::PixelFormat::Rgba8); }, 4};
};

TEST_F(FrameWorkersTest, OneThreadWritesInOrder) {
  FakeSink sink;
  FrameWorkers workers(sink, 1, error);
  submitAll(pool, {&workers});
  workers.drain();
  EXPECT_EQ(sink.indices(), numbers(0, kWorkedFrames));
  EXPECT_EQ(keptError(), "none");
}

TEST_F(FrameWorkersTest, GiveEachFrameItsOwnPicture) {
  FakeSink fast, slow("slow", -1, 1ms);
  FrameWorkers a(fast, 1, error), b(slow, 1, error);
  submitAll(pool, {&a, &b});
  a.drain();
  b.drain();
  for (const FakeSink* sink : {&fast, &slow}) {
    EXPECT_EQ(sink->indices(), numbers(0, kWorkedFrames));
    EXPECT_TRUE(std::equal(sink->indices().begin(), sink->indices().end(),
                           sink->firstBytes().begin(), sink->firstBytes().end()));
  }
}

TEST_F(FrameWorkersTest, SeveralThreadsWriteEachFrameOnce) {
  FakeSink sink("sink", -1, 1ms);
  FrameWorkers workers(sink, 3, error);
  submitAll(pool, {&workers});
  workers.drain();
  std::vector<std::int64_t> indices = sink.indices();
  std::sort(indices.begin(), indices.end());
  EXPECT_EQ(indices, numbers(0, kWorkedFrames));
}

// Three frames that are only written together need three threads.
class MeetingSink : public FrameSink {
 public:
  void write(std::int64_t, image::ImageView) override {
    ++here_;
    const auto end = std::chrono::steady_clock::now() + 5s;
    while (here_ < 3 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    if (here_ >= 3) ++met_;
  }
  void finish() override {}

  int met() const { return met_; }

 private:
  std::atomic<int> here_ = 0, met_ = 0;
};

TEST_F(FrameWorkersTest, SeveralThreadsWriteAtOnce) {
  MeetingSink sink;
  FrameWorkers workers(sink, 3, error);
  for (std::int64_t index = 0; index < 3; ++index) workers.submit({index, pool.take()});
  workers.drain();
  EXPECT_EQ(sink.met(), 3);
}

TEST_F(FrameWorkersTest, StillWriteWhatIsQueuedWhenTheyEnd) {
  FakeSink sink("sink", -1, 2ms);
  {
    FrameWorkers workers(sink, 1, error);
    for (std::int64_t index = 0; index < 4; ++index) workers.submit({index, pool.take()});
  }
  EXPECT_EQ(sink.indices(), numbers(0, 4));
}

TEST_F(FrameWorkersTest, CanBeDrainedTwice) {
  FakeSink sink;
  FrameWorkers workers(sink, 2, error);
  workers.drain();
  workers.drain();
  EXPECT_TRUE(sink.indices().empty());
}

// The pool has only four pictures: this hangs unless frames are let go.
TEST_F(FrameWorkersTest, LetFramesGoAfterAnError) {
  FakeSink sink("sink", 5);
  FrameWorkers workers(sink, 1, error);
  submitAll(pool, {&workers});
  workers.drain();
  EXPECT_EQ(sink.indices(), numbers(0, 5));
  EXPECT_EQ(keptError(), "sink fails at 5");
}

TEST_F(FrameWorkersTest, StopAllSinksAtTheFirstError) {
  FakeSink failing("failing", 3), slow("slow", -1, 1ms);
  FrameWorkers a(failing, 1, error), b(slow, 1, error);
  submitAll(pool, {&a, &b});
  a.drain();
  b.drain();
  const auto written = slow.indices();
  EXPECT_LT(written.size(), static_cast<std::size_t>(kWorkedFrames));
  EXPECT_EQ(written, numbers(0, static_cast<int>(written.size())));
  EXPECT_EQ(keptError(), "failing fails at 3");
}

TEST_F(FrameWorkersTest, KeepTheFirstOfTwoErrors) {
  FakeSink late("late", 40, 1ms), early("early", 2);
  FrameWorkers a(late, 1, error), b(early, 1, error);
  submitAll(pool, {&a, &b});
  a.drain();
  b.drain();
  EXPECT_EQ(keptError(), "early fails at 2");
}

TEST(FirstError, IsKeptAndThrownAgain) {
  system::FirstError error;
  EXPECT_NO_THROW(error.rethrow());
  error.set(std::make_exception_ptr(SinkFailure("first")));
  error.set(std::make_exception_ptr(SinkFailure("second")));
  for (int i = 0; i < 2; ++i) {
    try {
      error.rethrow();
      FAIL() << "nothing thrown";
    } catch (const SinkFailure& failure) {
      EXPECT_STREQ(failure.what(), "first");
    }
  }
}

}  // namespace
}  // namespace rotatebook::pipeline
