#include "pipeline/benchmark.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "pipeline/small_clip.h"

namespace rotatebook::pipeline {
namespace {

using ::testing::IsEmpty;

/// TMPDIR is `folder` while this lives.
class TemporaryFiles {
 public:
  explicit TemporaryFiles(const std::filesystem::path& folder) {
    setenv("TMPDIR", folder.c_str(), 1);
  }
  TemporaryFiles(const TemporaryFiles&) = delete;
  TemporaryFiles& operator=(const TemporaryFiles&) = delete;
  ~TemporaryFiles() { unsetenv("TMPDIR"); }
};

TEST(Speed, HasEachStageAndTheWholeAndLeavesNothing) {
  const auto folder = pipeline::testing::emptyFolder();
  const TemporaryFiles files(folder);
  std::vector<std::int64_t> done;
  SpeedOptions options{.frames = 10};
  options.progress = [&](std::int64_t now, std::int64_t total) {
    EXPECT_EQ(total, 30);
    done.push_back(now);
  };
  const auto speed =
      measureSpeed(pipeline::testing::smallScene({"overlay.show=['clock']"}), options);
  ASSERT_TRUE(speed.has_value());
  EXPECT_EQ(speed->frames, 10);
  EXPECT_GE(speed->cores, 1);
  EXPECT_EQ(speed->encoder, "libx264");
  EXPECT_FALSE(speed->renderer.empty());
  EXPECT_GT(speed->startUp, 0);
  EXPECT_GT(speed->whole.wall, 0);
  EXPECT_GT(speed->drawing.wall, 0);
  EXPECT_LT(speed->drawing.processor, speed->whole.processor);
  const StageTimes& stages = speed->stages;
  for (const WorkTime& time :
       {stages.simulate, stages.book, stages.compose, stages.png, stages.video}) {
    EXPECT_GT(time.wall, 0);
    EXPECT_GT(time.processor, 0);
  }
  EXPECT_DOUBLE_EQ(stages.processorSum(), stages.simulate.processor + stages.book.processor +
                                              stages.compose.processor + stages.png.processor +
                                              stages.video.processor);
  EXPECT_EQ(done.front(), 8);
  EXPECT_EQ(done.back(), 30);
  EXPECT_THAT(pipeline::testing::namesIn(folder), IsEmpty());
}

TEST(Speed, TakesPanelsAndBlurAndMotionsThatDiverge) {
  const TemporaryFiles files(pipeline::testing::emptyFolder());
  EXPECT_TRUE(measureSpeed(pipeline::testing::smallScene({"look.motion_blur=2"}), {.frames = 2}));
  EXPECT_TRUE(measureSpeed(pipeline::testing::smallScene({"panel=[{label='a'}, {label='b'}]"}),
                           {.frames = 2}));
  // Diverges in the sixth frame, whose second more is not asked for.
  EXPECT_TRUE(measureSpeed(pipeline::testing::divergingScene(), {.frames = 5}));
}

TEST(Speed, IsNothingIfStopped) {
  const auto folder = pipeline::testing::emptyFolder();
  const TemporaryFiles files(folder);
  std::atomic<bool> stop{false};
  SpeedOptions options{.frames = 10, .stop = &stop};
  for (const std::int64_t when : {8, 12, 22}) {
    stop = false;
    options.progress = [&](std::int64_t now, std::int64_t) { stop = stop || now >= when; };
    EXPECT_FALSE(measureSpeed(pipeline::testing::smallScene(), options)) << when;
  }
  EXPECT_THAT(pipeline::testing::namesIn(folder), IsEmpty());
}

TEST(Speed, SaysWhereTheTemporaryFolderCanNotBe) {
  const TemporaryFiles files("/nonexistent");
  const auto measure = [] { measureSpeed(pipeline::testing::smallScene(), {.frames = 1}); };
  EXPECT_EQ(pipeline::testing::messageOf<MachineError>(measure),
            "can't find a folder for temporary files: No such file or directory; let TMPDIR name a "
            "folder that can be written");
}

}  // namespace
}  // namespace rotatebook::pipeline
