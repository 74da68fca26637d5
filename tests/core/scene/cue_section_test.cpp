#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<Cue> cuesFrom(const std::string& text) {
  return sceneFrom(text).cues;
}

TEST(Cues, AreNoneUnlessStated) {
  EXPECT_THAT(cuesFrom(""), IsEmpty());
}

TEST(Cues, AreAtTimesOrEventsOfTheMotion) {
  const auto momentIn = [](const std::string& at) {
    return cuesFrom(
               "clip.duration = 9\n[[nudge]]\nat = 1\nangular_velocity = [1, 0, 0]\n[[cue]]\n" +
               at + "\ntext = 'a'\n")[0]
        .at;
  };
  EXPECT_EQ(momentIn(""), Moment{});
  EXPECT_EQ(momentIn("at = 2"), (Moment{.offset = 2}));
  EXPECT_EQ(momentIn("at = '1500 ms'"), (Moment{.offset = 1.5}));
  EXPECT_EQ(momentIn("at = 'nudge 1'"), (Moment{.event = Event::Nudge}));
  EXPECT_EQ(momentIn("at = '0.5 s before nudge 1'"),
            (Moment{.event = Event::Nudge, .offset = -0.5}));
  EXPECT_EQ(momentIn("at = '2 s before end'"), (Moment{.event = Event::End, .offset = -2}));
}

TEST(Cues, ArePrintedSoThatTheyAreReadAgain) {
  const std::string text =
      "[initial]\nangular_velocity = [0, 0, 6]\n[[panel]]\nlabel = 'one'\n[[panel]]\nlabel = "
      "'two of them'\n[[panel.nudge]]\nat = 3\nangular_velocity = [0, 0, 1]\n"
      "[[cue]]\nat = '1e-7 s after nudge 1 of two of them'\ntext = ''\nhold = '1.5 s'\n"
      "[[cue]]\nat = 'end'\nhold = 2\nchapter = 'The \"end\"'\n";
  const Scene scene = parseScene(text, "a.toml");
  ASSERT_EQ(scene.cues.size(), 2U);
  EXPECT_EQ(scene.cues[0].at, (Moment{Event::Nudge, 1, 1e-7, "two of them"}));
  const Scene again = parseScene(sceneText(scene), "a.toml");
  EXPECT_EQ(again.cues, scene.cues);
  EXPECT_EQ(again.shownCues, scene.shownCues);
  EXPECT_EQ(again.schedule, scene.schedule);
}

TEST(Cues, AreOfTheMotionWhereTheyHoldIt) {
  const std::string silent = motionText(sceneFrom(""));
  EXPECT_EQ(motionText(sceneFrom("[[cue]]\nat = 2\ntext = 'a'\nchapter = 'b'")), silent);
  EXPECT_THAT(motionText(sceneFrom("[[cue]]\nat = 2\ntext = 'a'\nhold = 1")),
              AllOf(HasSubstr("hold = 1"), Not(HasSubstr("text"))));
}

TEST(Cues, AreOverriddenByTheirNumber) {
  const Scene scene = sceneFrom("[[cue]]\nat = 2\ntext = 'a'", {"cue.0.text=b", "cue.0.at=3 s"});
  EXPECT_EQ(scene.cues[0].text, "b");
  EXPECT_EQ(scene.shownCues[0].time, 3);
}

TEST(Cues, AreLeftOutByAnEmptyList) {
  EXPECT_THAT(sceneFrom("[[cue]]\nat = 2\ntext = 'a'", {"cue=[]"}).cues, IsEmpty());
}

TEST(Cues, MustBeSomething) {
  EXPECT_EQ(errorOf("[[cue]]\nat = 2"), "a.toml:1:1: [[cue]] needs text, hold, chapter or move");
  EXPECT_MESSAGE(errorOf("[[cue]]\nat = 2\nmove = { over = 3 }"));
  EXPECT_MESSAGE(errorOf("[[cue]]\nat = 'flip'\ntext = 'a'"));
  for (const char* at :
       {"flip 0", "end 1", "burst of", "x before end", "-1 s before end", "flips 1"})
    EXPECT_MESSAGE(errorOf("[[cue]]\nat = '" + std::string(at) + "'\ntext = 'a'")) << at;
  EXPECT_MESSAGE(errorOf("[[caption]]\ntext = 'a'"));
}

TEST(Cues, MoveTheCamera) {
  const Cue cue = cuesFrom("[[cue]]\nmove = { orbit = '90 deg', position = [0, 0, 1] }\n")[0];
  ASSERT_TRUE(cue.move.has_value());
  EXPECT_NEAR(cue.move->orbit, 1.5707963267948966, 1e-16);  // measured 0
  EXPECT_EQ(cue.move->position, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(cue.move->over, 2);
  EXPECT_EQ(cue.move->target, std::nullopt);
}

TEST(Cues, RefuseMovesToWhereTheCameraSeesNothing) {
  EXPECT_EQ(
      errorOf("[[cue]]\nat = 1\nmove = { position = [0, 2, 0] }\n"),
      "a.toml:2:6: the camera's direction of view must not be parallel to camera.up, also after "
      "this cue");
  EXPECT_EQ(errorOf("[[cue]]\nat = 1\nmove = { position = [1, 2, 0], target = [1, 2, 0] }\n"),
            "a.toml:2:6: the camera's position and target must be different points, also after "
            "this cue");
}

}  // namespace
}  // namespace rotatebook::scene
