#include "overlay/marks.h"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "overlay/motion.h"

namespace rotatebook::overlay {
namespace {

using testing::diverging;
using testing::drawn;
using testing::greyPicture;
using testing::marksOf;
using testing::motionOf;
using testing::tumbling;

constexpr const char* kSmall = "clip.size=[320, 180]";

/// The first frame after a half-turn.
std::int64_t firstTurn(const physics::Trajectory& trajectory) {
  const auto& samples = trajectory.samples;
  const auto turned = std::ranges::find_if(
      samples, [](const physics::Sample& sample) { return sample.halfTurns == 1; });
  return turned - samples.begin();
}

TEST(Marks, LeaveThePictureAloneIfNothingIsShown) {
  const scene::Scene scene = tumbling({kSmall});
  EXPECT_EQ(drawn(scene, 3), greyPicture(scene));
  const physics::Trajectory trajectory = motionOf(scene);
  EXPECT_EQ(marksOf(scene, trajectory).bottomRows(), 0);
}

TEST(Marks, WriteTheLabelAtTheTop) {
  const scene::Scene scene = tumbling({kSmall});
  const physics::Trajectory trajectory = motionOf(scene);
  Marks marks(scene, trajectory, {.width = 320, .height = 180, .label = "matrix"});
  EXPECT_NE(drawn(marks, scene, 0), greyPicture(scene));
  ASSERT_EQ(marks.texts().size(), 1U);
  EXPECT_LT(marks.texts().front().bottom(), 45);
}

TEST(Marks, CountHalfTurnsAndLightUpWhenOneIsMade) {
  const scene::Scene scene = tumbling({kSmall, "overlay.show=['half_turns']"});
  const physics::Trajectory trajectory = motionOf(scene);
  Marks marks = marksOf(scene, trajectory);
  const std::int64_t turn = firstTurn(trajectory);
  ASSERT_GT(turn, 40);
  EXPECT_EQ(drawn(marks, scene, 0), drawn(marks, scene, turn - 1));
  EXPECT_NE(drawn(marks, scene, turn - 1), drawn(marks, scene, turn));
  EXPECT_NE(drawn(marks, scene, turn), drawn(marks, scene, turn + 10));
  EXPECT_EQ(drawn(marks, scene, turn + 25), drawn(marks, scene, turn + 30));
}

TEST(Marks, SayThatAMotionDivergedOnlyPastItsEnd) {
  const scene::Scene scene = diverging({kSmall});
  const physics::Trajectory trajectory = motionOf(scene);
  ASSERT_TRUE(trajectory.divergedAt);
  const auto last = static_cast<std::int64_t>(trajectory.samples.size()) - 1;
  Marks marks = marksOf(scene, trajectory);
  EXPECT_EQ(drawn(marks, scene, last), greyPicture(scene));
  EXPECT_TRUE(marks.texts().empty());
  EXPECT_NE(drawn(marks, scene, last + 1), greyPicture(scene));
  EXPECT_EQ(marks.texts().size(), 1U);
  EXPECT_EQ(drawn(marks, scene, last + 1), drawn(marks, scene, last + 9));
}

}  // namespace
}  // namespace rotatebook::overlay
