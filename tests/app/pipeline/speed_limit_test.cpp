#include "pipeline/speed_limit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rotatebook::pipeline {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A software rasteriser on two cores: 90 ms of work a frame.
Speed twoCores() {
  Speed speed;
  speed.cores = 2;
  speed.renderer = "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5, EGL device 0";
  speed.whole = {50, 95};
  speed.stages = {{0, 0}, {22, 40}, {4, 4}, {26, 26}, {20, 20}};
  return speed;
}

/// A graphics card and many cores: drawing costs little, one encoder thread most.
Speed graphicsCard() {
  Speed speed = twoCores();
  speed.cores = 16;
  speed.renderer = "NVIDIA H200";
  speed.stages.book = {2, 1};
  return speed;
}

std::vector<std::string> changes(const scene::Scene& scene, const Speed& speed) {
  std::vector<std::string> words;
  for (const SpeedAdvice& advice : speedAdvice(scene, speed)) words.push_back(advice.change);
  return words;
}

TEST(SpeedLimit, IsTheCoresIfAllAreBusy) {
  const SpeedLimit limit = speedLimit(twoCores().stages, 2);
  EXPECT_TRUE(limit.ofCores);
  EXPECT_EQ(limit.stage, Stage::Book);
  EXPECT_DOUBLE_EQ(limit.wall, 45);
}

TEST(SpeedLimit, IsTheStageForWhichOthersWait) {
  const SpeedLimit video = speedLimit(graphicsCard().stages, 16);
  EXPECT_FALSE(video.ofCores);
  EXPECT_EQ(video.stage, Stage::Video);
  EXPECT_DOUBLE_EQ(video.wall, 20);
  Speed speed = graphicsCard();
  speed.stages.compose = {21, 21};
  const SpeedLimit finish = speedLimit(speed.stages, 16);
  EXPECT_EQ(finish.stage, Stage::Compose);
  EXPECT_DOUBLE_EQ(finish.wall, 21);
}

TEST(SpeedAdvice, IsAboutTheStageThatLimits) {
  EXPECT_THAT(changes({}, twoCores()),
              ElementsAre("--size 640x360", "more cores", "a graphics card"));
  Speed speed = twoCores();
  speed.renderer = "Google SwiftShader";
  EXPECT_THAT(changes({}, speed), ElementsAre("--size 640x360", "more cores", "a graphics card"));
  speed.stages.png = {60, 60};
  EXPECT_THAT(changes({}, speed), ElementsAre("--size 640x360", "more cores", "--no-png"));
  EXPECT_THAT(changes({}, graphicsCard()),
              ElementsAre("a faster video.preset", "--set video.threads=16", "--size 640x360"));
}

TEST(SpeedAdvice, HasTheGainOfTheMeasuredTimes) {
  scene::Scene scene;
  scene.look.supersample = 2;
  Speed speed = twoCores();
  speed.stages.book = {80, 150};
  const std::vector<SpeedAdvice> advice = speedAdvice(scene, speed);
  ASSERT_EQ(advice.size(), 4U);
  EXPECT_EQ(advice[0].change, "a graphics card");
  EXPECT_DOUBLE_EQ(advice[0].gain, 100.0 / 25);
  EXPECT_EQ(advice[1].change, "--size 640x360");
  EXPECT_DOUBLE_EQ(advice[1].gain, 4);
  EXPECT_EQ(advice[2].change, "--set look.supersample=1");
  EXPECT_DOUBLE_EQ(advice[2].gain, 200.0 / 87.5);
  EXPECT_EQ(advice[3].change, "more cores");
  EXPECT_DOUBLE_EQ(advice[3].gain, 100.0 / 80);  // Drawing alone takes 80.
}

TEST(SpeedAdvice, LeavesOutWhatDoesNotHelp) {
  scene::Scene scene;
  scene.clip.width = 48;
  scene.clip.height = 36;
  scene.video.preset = "ultrafast";
  Speed speed = graphicsCard();
  speed.stages.compose = {19.9, 1};
  scene.video.threads = 16;
  EXPECT_THAT(changes(scene, speed), IsEmpty());
}

}  // namespace
}  // namespace rotatebook::pipeline
