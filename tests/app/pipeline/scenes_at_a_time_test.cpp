#include "pipeline/scenes_at_a_time.h"

#include <vector>

#include <gtest/gtest.h>

namespace rotatebook::pipeline {
namespace {

constexpr double kGigabyte = 1e9;

scene::Scene ofSize(int width, int height) {
  scene::Scene scene;
  scene.clip.width = width;
  scene.clip.height = height;
  return scene;
}

TEST(ScenesAtATime, AreTwoAndOneForThreeCores) {
  const std::vector<scene::Scene> scenes{ofSize(1280, 720)};
  EXPECT_EQ(scenesAtATime(scenes, 1, 64 * kGigabyte), 1);
  EXPECT_EQ(scenesAtATime(scenes, 2, 64 * kGigabyte), 2);
  EXPECT_EQ(scenesAtATime(scenes, 8, 64 * kGigabyte), 2);
  EXPECT_EQ(scenesAtATime(scenes, 9, 64 * kGigabyte), 3);
  EXPECT_EQ(scenesAtATime(scenes, 16, 64 * kGigabyte), 5);
}

TEST(ScenesAtATime, FitIntoAQuarterOfTheMemory) {
  const std::vector<scene::Scene> scenes{ofSize(1280, 720), ofSize(3840, 2160)};
  EXPECT_EQ(scenesAtATime(scenes, 16, 8 * kGigabyte), 2);
  EXPECT_EQ(scenesAtATime(scenes, 16, kGigabyte), 1);
  std::vector<scene::Scene> supersampled = scenes;
  supersampled[0].look.supersample = 2;
  EXPECT_EQ(scenesAtATime({supersampled[0]}, 64, 8 * kGigabyte), 4);
}

}  // namespace
}  // namespace rotatebook::pipeline
