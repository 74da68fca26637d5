#include "timeline/clip_tables.h"

#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_text.h"
#include "timeline/simulate_scene.h"
#include "timeline/trajectory_csv.h"

namespace rotatebook::timeline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr const char* kBook =
    "[initial]\nangular_velocity = [5, 0, 0]\ntilt = [0.1, 'z']\n[clip]\nduration = 0.5\n";

scene::Scene sceneOf(const std::string& rest) {
  return scene::parseScene(kBook + rest, "a.toml");
}

std::vector<std::vector<std::string>> cellsOf(const std::string& table) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

TEST(ClipTables, OfAMotionAndOfPanelsAreThoseOfTheMotions) {
  const scene::Scene one = sceneOf("");
  const ClipMotion motion = simulateScene(one);
  EXPECT_EQ(tableCount(one), 1U);
  EXPECT_EQ(tableText(one, motion, 0), trajectoryCsv(motion.trajectories()[0]));
  EXPECT_EQ(rowCount(one, motion, 0), 30U);
  const scene::Scene two = sceneOf("[[panel]]\nlabel = 'a'\n[[panel]]\nlabel = 'b'\nbody.mass = 2");
  const ClipMotion both = simulateScene(two);
  EXPECT_EQ(tableCount(two), 2U);
  EXPECT_EQ(tableText(two, both, 1), trajectoryCsv(both.trajectories()[1]));
}

TEST(ClipTables, OfAGridIsOneWithARowForEachCell) {
  const scene::Scene grid = sceneOf(
      "[grid]\ncolumns = { key = 'initial.tilt', values = [0.1, 0.01] }\n"
      "rows = { key = 'simulation.substeps', values = [1, 2, 4] }");
  const ClipMotion motion = simulateScene(grid);
  EXPECT_EQ(tableCount(grid), 1U);
  EXPECT_EQ(rowCount(grid, motion, 0), 6U);
  const auto rows = cellsOf(tableText(grid, motion, 0));
  ASSERT_THAT(rows, SizeIs(7));
  EXPECT_THAT(rows[0],
              ElementsAre("initial.tilt", "simulation.substeps", "time_s", "half_turns", "tilt_deg",
                          "energy_ratio", "rotational_ratio", "L_ratio", "stretch", "error_deg",
                          "regime", "centre_drift", "diverges_at"));
  EXPECT_EQ(rows[4][0], "0.01");
  EXPECT_EQ(rows[4][1], "2");
  const physics::Sample& last = motion.trajectories()[3].samples.back();
  EXPECT_EQ(std::stod(rows[4][2]), last.time);
  EXPECT_EQ(std::stod(rows[4][4]), last.tiltDeg);
  EXPECT_EQ(std::stod(rows[4][9]), last.errorDeg);
  EXPECT_THAT(rows[4], SizeIs(12)) << "nothing diverges";
}

TEST(ClipTables, QuoteLabelsWithCommas) {
  const scene::Scene grid = sceneOf(
      "[grid]\nrows = { key = 'simulation.substeps', values = ["
      "{ label = 'few, or so', value = 1 }, { label = 'two \"or\" more', value = 2 }] }");
  const std::string table = tableText(grid, simulateScene(grid), 0);
  EXPECT_THAT(table, HasSubstr("\n\"few, or so\",0.48"));
  EXPECT_THAT(table, HasSubstr("\n\"two \"\"or\"\" more\",0.48"));
}

TEST(ClipTables, SayWhenAMotionDiverges) {
  const scene::Scene grid = sceneOf(
      "[simulation]\nmodel = 'particles'\nsubsteps = 1\nnormalize = false\n[grid]\n"
      "columns = { key = 'simulation.stiffness', values = [100, 1e9] }");
  const ClipMotion motion = simulateScene(grid);
  ASSERT_TRUE(motion.trajectories()[1].divergedAt);
  const auto rows = cellsOf(tableText(grid, motion, 0));
  EXPECT_EQ(std::stod(rows[2].back()), *motion.trajectories()[1].divergedAt);
}

}  // namespace
}  // namespace rotatebook::timeline
