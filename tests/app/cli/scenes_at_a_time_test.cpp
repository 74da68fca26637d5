#include <vector>

#include <gtest/gtest.h>

#include "cli/render_scenes.h"

namespace rotatebook::cli {
namespace {

constexpr double kGigabyte = 1e9;

SceneToRender ofSize(int width, int height) {
  SceneToRender one;
  one.scene.clip.width = width;
  one.scene.clip.height = height;
  return one;
}

TEST(ScenesAtATime, AreOneForThreeCores) {
  const std::vector<SceneToRender> scenes{ofSize(1280, 720)};
  EXPECT_EQ(scenesAtATime(scenes, 1, 64 * kGigabyte), 1);
  EXPECT_EQ(scenesAtATime(scenes, 5, 64 * kGigabyte), 1);
  EXPECT_EQ(scenesAtATime(scenes, 6, 64 * kGigabyte), 2);
  EXPECT_EQ(scenesAtATime(scenes, 16, 64 * kGigabyte), 5);
}

TEST(ScenesAtATime, FitIntoAQuarterOfTheMemory) {
  const std::vector<SceneToRender> scenes{ofSize(1280, 720), ofSize(3840, 2160)};
  EXPECT_EQ(scenesAtATime(scenes, 16, 8 * kGigabyte), 2);
  EXPECT_EQ(scenesAtATime(scenes, 16, kGigabyte), 1);
  std::vector<SceneToRender> supersampled = scenes;
  supersampled[0].scene.look.supersample = 2;
  EXPECT_EQ(scenesAtATime({supersampled[0]}, 64, 8 * kGigabyte), 4);
}

}  // namespace
}  // namespace rotatebook::cli
