#include "cli/planning.h"

#include <gtest/gtest.h>

#include "farm/fake_slurm.h"
#include "scene/scene_text.h"
#include "store/fingerprint.h"
#include "study/map_runs.h"
#include "system/build_id.h"

namespace rotatebook::cli {
namespace {

SceneOfFile sceneOf(const std::string& more) {
  return {"clip.toml",
          scene::parseScene("title = \"T\"\n[initial]\nangular_velocity = [5.0, 0.0, "
                            "0.0]\ntilt = [0.1, \"z\"]\n[clip]\nsize = [64, 36]\nduration = 0.2\n" +
                                more,
                            "clip", {})};
}

constexpr const char* kMap =
    "[map]\nx = { key = \"simulation.substeps\", from = 1, to = 9 }\ny = { key = "
    "\"initial.tilt.0\", from = 0.1, to = 1.0 }\nmeasure = \"half_turns\"\nsize = [200, 100]\n";

TEST(Planning, CountsTheFramesThatThereAre) {
  const SceneOfFile one = sceneOf("");
  const farm::Plan plan = planOf({one}, {.folder = "/out", .formats = {video::VideoFormat::Mp4}});
  EXPECT_EQ(plan.scenes.at(0).units, 12);
  EXPECT_EQ(plan.scenes.at(0).parts, 1);
  EXPECT_EQ(plan.scenes.at(0).checksum, store::sceneChecksum(one.scene));
  EXPECT_TRUE(plan.scenes.at(0).file.is_absolute());
  EXPECT_TRUE(plan.program.is_absolute());
  EXPECT_EQ(plan.build, system::buildId());
  std::vector<std::string> names;
  for (const auto& output : plan.scenes.at(0).outputs) names.push_back(output.filename());
  EXPECT_EQ(names,
            (std::vector<std::string>{"clip.csv", "clip.json", "clip.poster.png", "clip.mp4"}));
}

TEST(Planning, CountsTheTilesOfAMapAndMeasuresThem) {
  const SceneOfFile one = sceneOf(kMap);
  const farm::Plan plan = planOf({one}, {.work = farm::Work::Map, .folder = "/out"});
  const auto tiles = study::MapRuns(one.scene).tiles();
  EXPECT_EQ(plan.scenes.at(0).units, std::ssize(tiles));
  EXPECT_EQ(plan.scenes.at(0).values, store::mapFingerprint(one.scene));
  const std::vector<farm::Effort> efforts = measureEfforts(plan, {one}, {});
  ASSERT_EQ(efforts.size(), 1U);
  EXPECT_EQ(efforts[0].units, plan.scenes[0].units);
  EXPECT_GT(efforts[0].unit, 0);
}

TEST(Planning, TakesAStudyAsOneTask) {
  const farm::Plan plan = planOf({sceneOf("")}, {.work = farm::Work::Study, .folder = "/out"});
  EXPECT_EQ(plan.scenes.at(0).units, 1);
  EXPECT_EQ(plan.scenes.at(0).outputs.size(), 2U);
}

}  // namespace
}  // namespace rotatebook::cli
