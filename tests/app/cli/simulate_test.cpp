// `rotatebook simulate`: a table without graphics.
#include <string>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

using SimulateCommand = ProgramTest;

constexpr const char* kHeader =
    "frame,time_s,qw,qx,qy,qz,wx,wy,wz,Lx,Ly,Lz,kinetic_J,potential_J,total_J,tilt_deg,half_turns,"
    "stretch_min,stretch_max,c0x,c0y,c0z,c1x,c1y,c1z,c2x,c2y,c2z,c3x,c3y,c3z,c4x,c4y,c4z,c5x,c5y,"
    "c5z,c6x,c6y,c6z,c7x,c7y,c7z,error_deg,energy_ratio,L_ratio,regime,centre_drift_m,"
    "last_flip_s\n";
constexpr int kColumns = 49;
constexpr int kTableRows = 12;

TEST_F(SimulateCommand, WritesATableWithoutGraphics) {
  const ChildResult result = runWithoutGraphics({"simulate", "tiny.toml", "--csv", "t.csv"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, MatchesRegex("tiny: Tiny\n  wrote t.csv, 12 rows\n"
                                          "  0 flips; energy kept to [0-9]e-1[0-9]; within "
                                          "[0-9]e-1[0-9] degrees of the exact motion\n"));
  EXPECT_THAT(files(), ElementsAre("t.csv"));
  EXPECT_THAT(read("t.csv"), StartsWith(kHeader));
  EXPECT_EQ(countOf("\n", read("t.csv")), 1 + kTableRows);
  EXPECT_EQ(countOf(",", read("t.csv")), (1 + kTableRows) * (kColumns - 1));
}

TEST_F(SimulateCommand, ReportsAloneWithoutATable) {
  const ChildResult result = runWithoutGraphics({"simulate", "tiny.toml"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, MatchesRegex("tiny: Tiny\n  0 flips; energy kept to [^\n]*\n"));
  EXPECT_THAT(files(), IsEmpty());
  const ChildResult unmet =
      run({"simulate", "tiny.toml", "--set", "expect.half_turns={ min = 3 }"});
  EXPECT_EQ(unmet.status, 1);
  EXPECT_EQ(unmet.error, "rotatebook: expectations are not met\n");
}

TEST_F(SimulateCommand, PrintsNothingButTheTableForADash) {
  run({"simulate", "tiny.toml", "--csv", "t.csv"});
  const ChildResult result = runWithoutGraphics({"simulate", "tiny.toml", "--csv", "-"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output, read("t.csv"));
  EXPECT_THAT(withoutDistances(result.error), IsEmpty());
  EXPECT_THAT(files(), ElementsAre("t.csv"));
}

TEST_F(SimulateCommand, PrintsExpectationsBesideTheTable) {
  const ChildResult result =
      run({"simulate", "tiny.toml", "--csv", "-", "--set", "expect.half_turns={min=1}"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, StartsWith(kHeader));
  EXPECT_EQ(countOf("\n", result.output), 1 + kTableRows);
  EXPECT_EQ(withoutDistances(result.error),
            "  not met  half_turns: expected at least 1; measured 0\n"
            "rotatebook: expectations are not met\n");
}

TEST_F(SimulateCommand, KeepsTheTableOfAnUnmetExpectation) {
  const ChildResult result =
      run({"simulate", "tiny.toml", "--csv", "t.csv", "--set", "expect.half_turns={min=1}"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(withoutDistances(result.output),
              EndsWith("12 rows\n  not met  half_turns: expected at least 1; measured 0\n"));
  EXPECT_THAT(files(), ElementsAre("t.csv"));
}

TEST_F(SimulateCommand, LeavesExpectationsOut) {
  const std::vector<std::string> words{"simulate", "tiny.toml", "--set", "expect.half_turns.min=1"};
  ASSERT_EQ(run(words).status, 1);
  std::vector<std::string> unjudged = words;
  unjudged.emplace_back("--no-expect");
  const ChildResult result = run(unjudged);
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, HasSubstr("\n  expectations are left out (--no-expect)\n"));
  EXPECT_EQ(countOf("UNMET", result.output), 0);
  unjudged.emplace_back("--json");
  EXPECT_THAT(run(unjudged).output, HasSubstr("\"judged\":false"));
}

TEST_F(SimulateCommand, TakesOverrides) {
  const ChildResult result =
      run({"simulate", "tiny.toml", "--csv", "-", "--set", "clip.duration=0.05", "--set",
           "initial.angular_velocity=[0, 0, 3]"});
  EXPECT_EQ(countOf("\n", result.output), 1 + 3);
  EXPECT_THAT(result.output, StartsWith(std::string(kHeader) + "0,0,1,0,0,0,0,0,"));
}

TEST_F(SimulateCommand, GivesTheTableOfTheRender) {
  run({"simulate", "tiny.toml", "--csv", "t.csv"});
  run({"render", "tiny.toml", "--no-png", "--no-mp4"});
  EXPECT_EQ(read("t.csv"), read("out/tiny.csv"));
}

TEST_F(SimulateCommand, SaysWhichSceneHasTooLongSteps) {
  const ChildResult result =
      runWithoutGraphics({"simulate", "tiny.toml", "--csv", "t.csv", "--set",
                          "simulation.integrator=dmv2", "--set", "simulation.time_per_frame=2",
                          "--set", "simulation.substeps=1", "--set", "initial.tilt=[0.3, 'z']"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(
      result.error,
      "note: tiny: the body spins by 1.59 turns from frame to frame, which no eye can follow; "
      "choose a shorter simulation.time_per_frame\n"
      "rotatebook: tiny.toml: the integrator dmv2 finds no solution for a step of 2 s: so "
      "long a step may have none; use shorter steps (more substeps)\n");
  EXPECT_THAT(files(), IsEmpty());
}

}  // namespace
}  // namespace rotatebook::cli::testing
