// [grid]: the motions of its cells, what they are called, what is expected of them, and what is
// refused.
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "scene/key_rows.h"
#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using ::testing::ElementsAre;

constexpr const char* kTilted = "[initial]\nangular_velocity = [5, 0, 0]\ntilt = [0.1, 'z']\n";
constexpr const char* kColumns =
    "columns = { key = 'initial.tilt', values = [0.1, 0.01, 0.001] }\n";
constexpr const char* kRows = "rows = { key = 'simulation.substeps', values = [2, 8] }\n";

Scene gridOf(const std::string& lines) {
  return parseScene(std::string(kTilted) + "[grid]\n" + lines, "a.toml");
}

/// The message about [grid] with these lines, the first of which is line 5 of the file.
std::string errorOfGrid(const std::string& lines) {
  return errorOfText(std::string(kTilted) + "[grid]\n" + lines);
}

std::vector<std::string> labelsOf(const Scene& scene) {
  std::vector<std::string> labels;
  for (const Panel& panel : scene.motions) labels.push_back(panel.label);
  return labels;
}

TEST(GridSection, HasAMotionForEachCellRowByRow) {
  const Scene scene = gridOf(std::string(kColumns) + kRows);
  EXPECT_THAT(labelsOf(scene), ElementsAre("tilt 0.1, substeps 2", "tilt 0.01, substeps 2",
                                           "tilt 0.001, substeps 2", "tilt 0.1, substeps 8",
                                           "tilt 0.01, substeps 8", "tilt 0.001, substeps 8"));
  EXPECT_EQ(scene.motions[5].simulation.substeps, 8);
  EXPECT_EQ(scene.motions[5].initial.tilt->angle, 0.001);
  EXPECT_EQ(scene.motions[5].initial.tilt->axis, gridOf(kColumns).motions[0].initial.tilt->axis);
  physics::MotionSettings rest = scene.motions[0].motion();
  rest.simulation.substeps = 8;
  rest.initial.tilt->angle = 0.001;
  EXPECT_EQ(scene.motions[5].motion(), rest);
}

TEST(GridSection, MayHaveColumnsOrRowsAlone) {
  EXPECT_THAT(labelsOf(gridOf(kColumns)), ElementsAre("tilt 0.1", "tilt 0.01", "tilt 0.001"));
  const Scene rows = gridOf(kRows);
  EXPECT_THAT(labelsOf(rows), ElementsAre("substeps 2", "substeps 8"));
  EXPECT_EQ(rows.grid->columnCount(), 1U);
  EXPECT_EQ(rows.grid->rowCount(), 2U);
}

TEST(GridSection, TakesRangesWordsUnitsAndLabels) {
  const Scene scene = gridOf(
      "columns = { key = 'simulation.integrator', values = ['euler', 'rk4'] }\n"
      "rows = { key = 'initial.tilt', values = ['1 deg', '2 deg'] }");
  EXPECT_EQ(scene.motions[1].simulation.integrator, physics::Integrator::Rk4);
  EXPECT_NEAR(scene.motions[2].initial.tilt->angle, 0.0349066, 1e-7);  // 2 deg
  EXPECT_EQ(scene.motions[2].label, "integrator euler, tilt 2 deg");
  const Scene range = gridOf(
      "columns = { key = 'simulation.substeps',"
      " from = 1, to = 100, count = 3, scale = 'log' }");
  EXPECT_EQ(range.motions[1].simulation.substeps, 10);
  const Scene tilts =
      gridOf("rows = { key = 'initial.tilt', from = '1 deg', to = '0.25 turn', count = 3 }");
  EXPECT_EQ(tilts.motions[0].initial.tilt->angle, std::numbers::pi / 180);
  EXPECT_EQ(tilts.motions[2].initial.tilt->angle, std::numbers::pi / 2);
  const Scene spins = gridOf(
      "columns = { key = 'initial.angular_velocity', label = 'spin',"
      " values = [{ label = 'x', value = [4, 0, 0] }, { label = 'y', value = [0, 4, 0] }] }");
  EXPECT_EQ(spins.motions[1].initial.value.y(), 4);
}

TEST(GridSection, ReadsBackTheSameFromItsText) {
  const Scene scene = gridOf(std::string(kColumns) + kRows +
                             "expect = [{ of = 'half_turns', column = 0.01, row = 8, min = 1 }, { "
                             "of = 'L_ratio', max = 2 }]\n"
                             "[expect]\nerror_deg = { max = 180 }");
  const Scene again = parseScene(sceneText(scene), "a.toml");
  EXPECT_EQ(again.grid, scene.grid);
  EXPECT_EQ(again.motions, scene.motions);
  EXPECT_EQ(sceneText(again), sceneText(scene));
}

TEST(GridSection, ExpectsOfAllOfARowOfAColumnOrOfACell) {
  const Scene scene =
      gridOf(std::string(kColumns) + kRows +
             "expect = [{ of = 'half_turns', column = 0.01, row = 8, min = 1 },"
             " { of = 'L_ratio', row = 2, max = 2 }, { of = 'L_ratio', column = 0.1, min = 0.5 }]\n"
             "[expect]\nerror_deg = { max = 180 }");
  std::vector<std::size_t> counts;
  for (const Panel& panel : scene.motions) counts.push_back(panel.expectations.size());
  EXPECT_THAT(counts, ElementsAre(3, 2, 2, 2, 2, 1));
  EXPECT_EQ(scene.motions[4].expectations.back().measure, Measure::HalfTurns);
}

TEST(GridSection, NamesItsAxesWithUnits) {
  const GridSettings grid = *gridOf(std::string(kColumns) + kRows).grid;
  EXPECT_EQ(nameOf(*grid.columns), "initial.tilt  [rad]");
  EXPECT_EQ(nameOf(*grid.rows), "simulation.substeps");
  EXPECT_EQ(nameOf(Axis{"nudge.0.at", {{"1", "1", 1.0}}}), "nudge.0.at  [s]");
  EXPECT_EQ(nameOf(Axis{"body.size.2", {{"1", "1", 1.0}}}), "body.size.2  [m]");
  EXPECT_EQ(nameOf(Axis{"body.size.2", {{"'1 cm'", "1 cm", {}}}}), "body.size.2")
      << "the values have a unit of their own";
  EXPECT_EQ(nameOf(Axis{"body.mass", {{"1", "1", 1.0}}, "mass of the book"}), "mass of the book");
}

TEST(GridSection, RefusesKeysThatChangeNothing) {
  EXPECT_EQ(errorOfGrid("columns = { key = 'simulation.substep', values = [1, 2] }"),
            "a.toml:5:19: unknown key \"substep\" in [simulation]; did you mean \"substeps\"?");
  EXPECT_MESSAGE(errorOfGrid("columns = { key = 'look.supersample', values = [1, 2] }"));
  EXPECT_EQ(errorOfGrid("columns = { key = 'simulation.stiffness', values = [1, 2] }"),
            "a.toml:5:19: simulation.stiffness is of the model \"particles\" alone; all books "
            "would be the same");
  EXPECT_EQ(errorOfText(std::string(kTilted) +
                        "[simulation]\nmodel = 'exact'\n[grid]\n"
                        "columns = { key = 'simulation.substeps', values = [1, 2] }"),
            "a.toml:7:19: simulation.substeps: the model \"exact\" takes no steps; all books "
            "would be the same");
  EXPECT_MESSAGE(errorOfGrid("columns = { key = 'simulation.time_per_frame', values = [1, 2] }"));
  EXPECT_MESSAGE(
      errorOfText("[initial]\nangular_velocity = [5, 0, 0]\n[grid]\n" + std::string(kColumns)));
  EXPECT_MESSAGE(errorOfGrid("columns = { key = 'initial.angular_momentum.0', values = [1, 2] }"));
  EXPECT_EQ(gridOf("rows = { key = 'initial.angular_momentum', "
                   "values = [{ label = 'm', value = [0, 0, 1] }] }\n"
                   "columns = { key = 'initial.angular_momentum.0', values = [1, 2] }")
                .motions[1]
                .initial.value,
            Eigen::Vector3d(2, 0, 1));
}

TEST(GridSection, RefusesValues) {
  EXPECT_MESSAGE(errorOfGrid("columns = { key = 'simulation.substeps', values = [1, 0] }"));
  EXPECT_MESSAGE(errorOfGrid("columns = { key = 'simulation.substeps', values = [1, 'two'] }"));
  EXPECT_MESSAGE(errorOfGrid("columns = { key = 'simulation.substeps', values = [] }"));
  EXPECT_MESSAGE(errorOfGrid("columns = { key = 'simulation.substeps', values = [2, 2] }"));
  EXPECT_MESSAGE(
      errorOfGrid("columns = { key = 'simulation.substeps', from = 8, to = 1, "
                  "count = 3 }"));
  EXPECT_MESSAGE(
      errorOfGrid("columns = { key = 'initial.tilt', from = 0, to = 1, "
                  "count = 3, scale = 'log' }"));
}

TEST(GridSection, RefusesMoreBooksThanHaveRoom) {
  const std::string twelve = "[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]";
  EXPECT_EQ(gridOf("columns = { key = 'simulation.substeps', values = " + twelve +
                   " }\nrows = { key = 'initial.tilt', values = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, "
                   "1e-6, 1e-7, 1e-8] }")
                .motions.size(),
            96U);
  EXPECT_MESSAGE(errorOfGrid("columns = { key = 'simulation.substeps', values = " + twelve +
                             " }\nrows = { key = 'initial.tilt', values = [1e-1, 1e-2, 1e-3, 1e-4, "
                             "1e-5, 1e-6, 1e-7, 1e-8, 1e-9] }"));
  EXPECT_MESSAGE(
      errorOfGrid("rows = { key = 'simulation.substeps', from = 1, to = 13, "
                  "count = 13 }"));
  EXPECT_MESSAGE(errorOfGrid("rows = { key = 'simulation.substeps', values = [4] }"));
  EXPECT_MESSAGE(errorOfText(std::string(kTilted) + "[clip]\nduration = 9999\nfps = 240\n[grid]\n" +
                             kColumns));
}

TEST(GridSection, RefusesWhatDoesNotGoTogether) {
  const std::string grid = "[grid]\n" + std::string(kColumns);
  EXPECT_MESSAGE(errorOfText(kTilted + grid + "[[panel]]\nlabel = 'a'\n[[panel]]\nlabel = 'b'"));
  EXPECT_MESSAGE(errorOfText(kTilted + grid + "[study]\nsteps = [1, 2]"));
  EXPECT_MESSAGE(errorOfText(kTilted + grid +
                             "[map]\nx = { key = 'time', from = 0, to = 1 }\n"
                             "y = { key = 'body.mass', from = 1, to = 2 }\nmeasure = 'tilt_deg'"));
  EXPECT_MESSAGE(errorOfGrid(""));
  EXPECT_MESSAGE(errorOfGrid(std::string(kColumns) + "rows = { key = 'initial.tilt.0', values = "
                                                     "[1, 2] }"));
}

TEST(GridSection, RefusesExpectationsOfNoCell) {
  EXPECT_MESSAGE(
      errorOfGrid(std::string(kColumns) + "expect = { of = 'half_turns', column = 0.5, min = 1 }"));
  EXPECT_MESSAGE(
      errorOfGrid(std::string(kColumns) + "expect = { of = 'half_turns', row = 1, min = 1 }"));
  EXPECT_MESSAGE(errorOfGrid(std::string(kColumns) + "expect = { column = 0.1, min = 1 }"));
  EXPECT_MESSAGE(errorOfGrid(std::string(kColumns) + "expect = { of = 'half_turns' }"));
}

TEST(GridSection, RefusesKeysThatCannotVary) {
  EXPECT_EQ(errorOf("[grid]\ncolumns = { key = 'body.mesh', values = ['a.ply', 'b.ply'] }"),
            "a.toml:2:19: body.mesh can't vary; [[panel]] shows several meshes side by side");
  EXPECT_EQ(
      errorOf("[grid]\ncolumns = { key = 'nudge.0.at', values = [1, 2] }"),
      "a.toml:2:19: nudge.0.at is a part of a [[nudge]], and the scene states none; state it");
}

}  // namespace
}  // namespace rotatebook::scene
