// Drawing into sinks that run beside it, by a painter that needs no graphics.
#include "pipeline/draw_frames.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/fake_sinks.h"
#include "pipeline/small_clip.h"

namespace rotatebook::pipeline {
namespace {

using testing::emptyFolder;
using testing::FakeSink;
using testing::messageOf;
using testing::numbers;
using testing::SinkFailure;

constexpr std::int64_t kMaxInFlight = 8;
constexpr std::int64_t kMaxExposed = 3;
constexpr std::int64_t kMany = 40;

/// Paints frame n in the colour n; fails where it is told to.
class FakePainter : public picture::FramePainter {
 public:
  image::Image makePicture() const override { return {4, 2, image::PixelFormat::Rgba8}; }
  picture::Exposure makeExposure() const override { return {}; }

  void expose(std::int64_t frame, picture::Exposure& exposure) override {
    if (frame == failToExpose) throw std::runtime_error("no exposure");
    exposure.frame = frame;
    ++exposed_;
    exposed_.notify_all();
  }

  void compose(const picture::Exposure& exposure, image::Image& picture) override {
    if (exposure.frame == failToFinish) throw std::runtime_error("no picture");
    for (int y = 0; y < picture.height(); ++y) {
      std::fill_n(picture.row(y), picture.stride(), static_cast<std::uint8_t>(exposure.frame));
    }
  }

  /// Returns the number of frames so far.
  std::int64_t exposed() const { return exposed_; }
  /// Waits until there are `count`.
  void waitForExposed(std::int64_t count) const {
    for (std::int64_t now = exposed_; now < count; now = exposed_) exposed_.wait(now);
  }

  std::int64_t failToExpose = -1, failToFinish = -1;

 private:
  std::atomic<std::int64_t> exposed_ = 0;
};

/// Is done with a frame only once kLag later ones are exposed; of frames 0 to kMany.
class LaggingSink : public FakeSink {
 public:
  static constexpr std::int64_t kLag = 4;

  explicit LaggingSink(const FakePainter& painter) : painter_(painter) {}

  void write(std::int64_t index, image::ImageView picture) override {
    painter_.waitForExposed(std::min(index + 1 + kLag, kMany));
    FakeSink::write(index, picture);
  }

 private:
  const FakePainter& painter_;
};

/// Expects these frames in this order, each in its own picture.
void expectFrames(const FakeSink& sink, const std::vector<std::int64_t>& frames) {
  EXPECT_EQ(sink.indices(), frames);
  EXPECT_EQ(sink.firstBytes(), std::vector<std::uint8_t>(frames.begin(), frames.end()));
}

class DrawFrames : public ::testing::Test {
 protected:
  std::int64_t draw(store::FrameRange range, const std::vector<SinkThreads>& sinks,
                    const std::function<void(RenderProgress)>& progress = {}) {
    return drawFrames(painter_, {range, nullptr, &stop_}, sinks, progress).total();
  }

  std::string failureOf(const std::vector<SinkThreads>& sinks) {
    return messageOf<SinkFailure>([&] { draw({0, kMany}, sinks); });
  }

  FakePainter painter_;
  std::atomic<bool> stop_ = false;
};

TEST_F(DrawFrames, GivesEachSinkAllFramesInOrder) {
  FakeSink fast;
  LaggingSink slow(painter_);
  EXPECT_EQ(draw({0, kMany}, {{fast, 1}, {slow, 1}}), kMany);
  expectFrames(fast, numbers(0, kMany));
  expectFrames(slow, numbers(0, kMany));
}

TEST_F(DrawFrames, GivesASinkWithThreadsEachFrameOnce) {
  FakeSink sink;
  EXPECT_EQ(draw({0, kMany}, {{sink, 3}}), kMany);
  std::vector<std::int64_t> indices = sink.indices();
  EXPECT_EQ(sink.firstBytes(), std::vector<std::uint8_t>(indices.begin(), indices.end()));
  std::sort(indices.begin(), indices.end());
  EXPECT_EQ(indices, numbers(0, kMany));
}

TEST_F(DrawFrames, GivesTheSamePicturesToAnyNumberOfThreads) {
  HashSink one, four;
  draw({0, kMany}, {{one, 1}, {four, 4}});
  EXPECT_EQ(one.checksums().size(), static_cast<std::size_t>(kMany));
  EXPECT_EQ(four.checksums(), one.checksums());
}

TEST_F(DrawFrames, DrawsOnlyTheRange) {
  FakeSink sink;
  EXPECT_EQ(draw({7, 11}, {{sink, 1}}), 4);
  expectFrames(sink, numbers(7, 11));
  EXPECT_EQ(painter_.exposed(), 4);
}

TEST_F(DrawFrames, PaintsNoFrameThatIsKept) {
  const auto folder = emptyFolder();
  store::FrameChecksums earlier(folder);
  PngSequenceSink png(earlier, false);
  draw({3, 5}, {{png, 1}});
  const store::FrameChecksums sums(folder);
  FakeSink all, fresh;
  const DrawnCount count = drawFrames(painter_, {{2, 7}, &sums}, {{all, 1}, {fresh, 1, false}}, {});
  EXPECT_EQ(count.drawn, 3);
  EXPECT_EQ(count.kept, 2);
  expectFrames(all, {2, 3, 4, 5, 6});
  expectFrames(fresh, {2, 5, 6});
  EXPECT_EQ(painter_.exposed(), 2 + 3);
}

TEST_F(DrawFrames, LeavesFinishingToTheCaller) {
  FakeSink sink;
  draw({0, 3}, {{sink, 1}});
  EXPECT_FALSE(sink.finished());
}

TEST_F(DrawFrames, ReportsItsProgressFromNoneToAll) {
  FakeSink sink;
  std::vector<std::int64_t> done;
  draw({2, 6}, {{sink, 1}}, [&](RenderProgress progress) {
    done.push_back(progress.done);
    EXPECT_EQ(progress.total, 4);
  });
  EXPECT_EQ(done, numbers(0, 5));
}

TEST_F(DrawFrames, KeepsTheNumberOfPicturesInFlight) {
  LaggingSink sink(painter_);
  std::int64_t most = 0;
  draw({0, kMany}, {{sink, 1}},
       [&](RenderProgress progress) { most = std::max(most, progress.done - sink.written()); });
  // A frame may be written and its picture back before it is counted, or the other way round.
  EXPECT_LE(most, kMaxInFlight + kMaxExposed + 1);
  EXPECT_GE(most, LaggingSink::kLag) << "the sink is waited for";
  EXPECT_LE(sink.pictures().size(), static_cast<std::size_t>(kMaxInFlight));
}

TEST_F(DrawFrames, ThrowsTheErrorOfASink) {
  for (const std::int64_t failAt : {std::int64_t{0}, std::int64_t{17}, kMany - 1}) {
    FakeSink failing("failing", failAt), whole;
    EXPECT_EQ(failureOf({{whole, 1}, {failing, 1}}), "failing fails at " + std::to_string(failAt));
    EXPECT_EQ(failing.indices(), numbers(0, failAt));
  }
}

TEST_F(DrawFrames, ThrowsTheErrorOfThePainter) {
  const auto failure = [&] {
    FakeSink sink;
    const std::string message = messageOf<std::runtime_error>([&] {
      draw({0, kMany}, {{sink, 1}});
    });
    EXPECT_LE(sink.written(), 5);
    return message;
  };
  painter_.failToFinish = 5;
  EXPECT_EQ(failure(), "no picture");
  painter_.failToExpose = 3;
  EXPECT_EQ(failure(), "no exposure");
}

TEST_F(DrawFrames, StopsSoonAfterAnError) {
  FakeSink failing("failing", 3), whole;
  failureOf({{failing, 1}, {whole, 1}});
  EXPECT_LT(whole.written(), kMany);
}

TEST_F(DrawFrames, ThrowsTheFirstErrorOfTwoSinks) {
  FakeSink late("late", 30), early("early", 1);
  EXPECT_EQ(failureOf({{late, 1}, {early, 1}}), "early fails at 1");
}

TEST_F(DrawFrames, ThrowsTheErrorOfOneThreadOfMany) {
  FakeSink failing("failing", 9), whole;
  EXPECT_EQ(failureOf({{failing, 3}, {whole, 1}}), "failing fails at 9");
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
