// --set: what overrides make of a scene.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

using physics::InitialSpin;
using physics::Model;

TEST(Overrides, ReplaceValuesOfTheFile) {
  const Scene scene =
      sceneFrom("simulation.substeps = 3\nsimulation.damping = 0.5", {"simulation.substeps=10"});
  EXPECT_EQ(scene.motions[0].simulation.substeps, 10);
  EXPECT_EQ(scene.motions[0].simulation.damping, 0.5);
}

TEST(Overrides, AddKeysAndSections) {
  const Scene scene =
      sceneFrom("", {"clip.size=[640,360]", "expect.half_turns.min=3", "title=\"x\"",
                     "initial.tilt=[0.01,\"z\"]", "initial.angular_velocity=[0,6,0]"});
  EXPECT_EQ(scene.clip.width, 640);
  EXPECT_EQ(scene.clip.height, 360);
  ASSERT_EQ(scene.motions[0].expectations.size(), 1u);
  EXPECT_EQ(scene.motions[0].expectations[0].min, 3);
  EXPECT_EQ(scene.title, "x");
  EXPECT_EQ(scene.motions[0].initial.tilt, (physics::Tilt{0.01, 2}));
}

TEST(Overrides, MayBeTheWholeScene) {
  const Scene scene =
      parseScene("", "a.toml", std::vector<std::string>{"initial={angular_momentum=[1,2,3]}"});
  EXPECT_EQ(scene.motions[0].initial.value, Eigen::Vector3d(1, 2, 3));
}

TEST(Overrides, TakeBareStrings) {
  const Scene scene = sceneFrom("", {"simulation.model=matrix", "clip.fps=30000/1001",
                                     "title=Don't \"panic\" = [1", "caption="});
  EXPECT_EQ(scene.motions[0].simulation.model, Model::Matrix);
  EXPECT_EQ(scene.clip.frameRate, (FrameRate{30000, 1001}));
  EXPECT_EQ(scene.title, "Don't \"panic\" = [1");
  EXPECT_EQ(scene.caption, "");
}

TEST(Overrides, IgnoreBlanksAroundKeyAndValue) {
  EXPECT_EQ(sceneFrom("", {" video.crf = 3 "}).video.crf, 3);
  EXPECT_EQ(sceneFrom("", {"simulation.model = matrix "}).motions[0].simulation.model,
            Model::Matrix);
}

TEST(Overrides, CountInTheirOrder) {
  EXPECT_EQ(sceneFrom("", {"video.crf=3", "video.crf=4"}).video.crf, 4);
  EXPECT_EQ(
      sceneFrom("", {"expect={half_turns={min=3}}", "expect={}"}).motions[0].expectations.size(),
      0u);
}

TEST(Overrides, MoveTheDefaultsThatDependOnThem) {
  EXPECT_EQ(sceneFrom("clip.fps = 50", {"clip.fps=25"}).motions[0].simulation.timePerFrame,
            1.0 / 25);
}

TEST(Overrides, ReplaceTheSpinWhicheverKeyGaveIt) {
  const Scene momentum = sceneFrom("", {"initial.angular_momentum=[1,0,0]"});
  EXPECT_EQ(momentum.motions[0].initial.kind, InitialSpin::Kind::AngularMomentum);
  EXPECT_EQ(momentum.motions[0].initial.value, Eigen::Vector3d(1, 0, 0));
  const Scene velocity =
      sceneFrom("", {"initial.angular_momentum=[1,0,0]", "initial.angular_velocity=[2,0,0]"});
  EXPECT_EQ(velocity.motions[0].initial.kind, InitialSpin::Kind::AngularVelocity);
  EXPECT_EQ(velocity.motions[0].initial.value, Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(errorOf("", {"initial={angular_velocity=[1,0,0],angular_momentum=[1,0,0]}"}),
            "--set initial={angular_velocity=[1,0,0],angular_momentum=[1,0,0]}: [initial] has both "
            "angular_velocity and angular_momentum; keep one of them");
}

TEST(Overrides, AreThePlaceOfTheirProblems) {
  EXPECT_EQ(errorOf("simulation.substeps = 3", {"simulation.substeps=0"}),
            "--set simulation.substeps=0: simulation.substeps must be an integer from 1 to "
            "1000000, not 0");
  EXPECT_EQ(errorOf("", {"simulation.substep=3"}),
            "--set simulation.substep=3: unknown key \"substep\" in [simulation]; did you mean "
            "\"substeps\"?");
  EXPECT_EQ(errorOf("", {"simulaton.substeps=3"}),
            "--set simulaton.substeps=3: unknown section \"simulaton\"; did you mean "
            "\"simulation\"?");
  EXPECT_EQ(errorOf("", {"clip.size=[640,361]"}),
            "--set clip.size=[640,361]: clip.size must be even, not 361; the nearest even sizes "
            "are 360 and 362");
  EXPECT_EQ(errorOf("", {"simulation.model=matrx"}),
            "--set simulation.model=matrx: simulation.model must be \"particles\", \"matrix\", "
            "\"quaternion\", \"exact\" or \"recorded\", not \"matrx\"; did you mean \"matrix\"?");
  EXPECT_EQ(errorOf("", {"video.crf=1O"}),
            "--set video.crf=1O: video.crf must be an integer from 1 to 51, not \"1O\"");
}

TEST(Overrides, ArePrintedOnALine) {
  EXPECT_THAT(errorOf("", {"clip.fps=\x1b[31m\n\t"}),
              ::testing::StartsWith("--set clip.fps=\\u001B[31m\\n\\t: clip.fps must"));
  const std::string letters(180, 'x');
  EXPECT_THAT(errorOf("", {"clip.fps=" + letters + letters}),
              ::testing::StartsWith("--set clip.fps=" + letters + "xxxxxxxxxxx...: clip.fps must"));
}

}  // namespace
}  // namespace rotatebook::scene
