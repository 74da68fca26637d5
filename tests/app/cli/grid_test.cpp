// Grids of books on the command line.
#include <string>

#include "cli/program_test.h"
#include "messages.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kOne = R"(title = "One"
book.color = "#2b5d8a"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
tilt = [0.1, "z"]
[clip]
size = [160, 90]
duration = 0.1
[expect]
half_turns = { min = 1 }
)";

constexpr const char* kGrid = R"(
[grid]
columns = { key = "initial.tilt", values = [0.1, 0.01, 0.001] }
rows = { key = "simulation.substeps", values = [1, 4] }
)";

class GridCommands : public ProgramTest {
 protected:
  GridCommands() {
    write("one.toml", kOne);
    write("grid.toml", std::string(kOne) + kGrid);
  }
};

TEST_F(GridCommands, RenderLeavesOneTableWithARowForEachBook) {
  const ChildResult result = run({"render", "grid.toml", "--set", "expect={}"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("out/grid.mp4, out/grid.csv, out/grid.json, "
                                       "out/grid.poster.png and 6 frames in out/grid/\n"));
  const std::string table = read("out/grid.csv");
  EXPECT_THAT(table, StartsWith("initial.tilt,simulation.substeps,time_s,half_turns,"));
  EXPECT_EQ(countOf("\n", table), 7);
  EXPECT_THAT(table, HasSubstr("\n0.01,4,"));
  EXPECT_EQ(
      runWithoutGraphics({"simulate", "grid.toml", "--csv", "-", "--set", "expect={}"}).output,
      table);
  const ChildResult verified = run({"verify", "out/grid.mp4"});
  EXPECT_EQ(verified.status, 0) << verified.output << verified.error;
}

TEST_F(GridCommands, AnOptionMakesTheSameGrid) {
  const ChildResult asked =
      runWithoutGraphics({"check", "--print", "one.toml", "--grid",
                          "initial.tilt=0.1, 0.01,0.001 x simulation.substeps=[1, 4]"});
  EXPECT_EQ(asked.status, 0) << asked.error;
  const ChildResult stated =
      runWithoutGraphics({"check", "--print", "grid.toml", "--set", "expect={}"});
  EXPECT_EQ(asked.output, stated.output);
  EXPECT_THAT(asked.output, Not(HasSubstr("[expect]"))) << "what the single book must show";
}

TEST_F(GridCommands, AnOptionTakesWholeNumbersWordsAndRanges) {
  const auto sceneOf = [&](const std::string& grid) {
    return runWithoutGraphics({"check", "--print", "one.toml", "--grid", grid}).output;
  };
  EXPECT_THAT(sceneOf("simulation.substeps=1..8"),
              HasSubstr("columns = { key = \"simulation.substeps\", values = [1, 2, 3, 4, 5, 6, 7, "
                        "8] }\n"));
  for (const char* tilts : {"1 deg..3 deg", "1deg..3 deg"}) {
    EXPECT_THAT(sceneOf(std::string("initial.tilt=") + tilts + " x simulation.substeps=1..2"),
                HasSubstr("values = [\"1 deg\", \"2 deg\", \"3 deg\"]"));
  }
  EXPECT_THAT(sceneOf("simulation.integrator=euler,rk4"),
              HasSubstr("values = [\"euler\", \"rk4\"]"));
  EXPECT_THAT(sceneOf("simulation.substeps={ from = 1, to = 100, count = 3, scale = \"log\" }"),
              HasSubstr("values = [1, 10, 100]"));
}

TEST_F(GridCommands, RefusalsNameTheOption) {
  const auto errorOf = [&](const std::string& grid) {
    const ChildResult result = runWithoutGraphics({"render", "one.toml", "--grid", grid});
    EXPECT_EQ(result.status, 2) << grid;
    EXPECT_THAT(result.output, IsEmpty());
    return result.error;
  };
  EXPECT_MESSAGE(errorOf("simulation.substeps"));
  EXPECT_MESSAGE(errorOf("simulation.substep=1,2"));
  EXPECT_MESSAGE(errorOf("simulation.substeps=8..1"));
  EXPECT_MESSAGE(errorOf("simulation.substeps=1..99"));
  EXPECT_MESSAGE(errorOf("initial.tilt=9 deg..1 deg"));
  EXPECT_MESSAGE(errorOf("initial.tilt=1..3 deg"));
  EXPECT_MESSAGE(errorOf("initial.tilt=1 s..3 s"));
  EXPECT_MESSAGE(errorOf("simulation.substeps=1,,2"));
  EXPECT_MESSAGE(errorOf("simulation.substeps={ from = 1"));
  EXPECT_MESSAGE(errorOf("body.mass=1,2 x initial.tilt=1,2 x simulation.substeps=1,2"));
  EXPECT_MESSAGE(errorOf("initial.tilt={ from = 0, to = 1, count = 3, scale = \"log\" }"));
  // Found once the texts are laid out
  const std::string twelve = "simulation.substeps=1..12 x body.mass=1,2,3,4,5,6,7,8";
  EXPECT_MESSAGE(errorOf(twelve));
  EXPECT_THAT(files(), ElementsAre("grid.toml", "one.toml"));
}

TEST_F(GridCommands, ReportsExpectationsOfTheCellsThatHaveThem) {
  const ChildResult result = runWithoutGraphics(
      {"simulate", "grid.toml", "--set", "expect={}", "--set", "clip.duration=0.2", "--set",
       "grid.rows.values=[1, 4, 8]", "--set",
       "grid.expect=[{ of = \"half_turns\", column = 0.01, row = 4, max = 0 }]"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("  9 motions: 0 to 0 flips; none diverged\n"
                                       "  tilt 0.01, substeps 4:\n"
                                       "  met      half_turns: expected at most 0; measured 0\n"));
}

TEST_F(GridCommands, ABookThatDivergesIsShownAsSuch) {
  const ChildResult result =
      run({"render", "one.toml", "--no-png", "--set", "simulation.model=particles", "--set",
           "simulation.normalize=false", "--set", "clip.duration=1", "--grid",
           "simulation.substeps=1,100 x simulation.stiffness=100,1e5"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("the motion diverges at"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
