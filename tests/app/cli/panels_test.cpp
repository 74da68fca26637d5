// Scenes with panels on the command line.
#include <string>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;

constexpr const char* kPair = R"(title = "Pair"
book.color = "#2b5d8a"
initial.angular_velocity = [5.0, 0.0, 0.005]
[clip]
size = [96, 54]
duration = 0.2
[[panel]]
label = "one"
expect.half_turns = { max = 0 }
[[panel]]
label = "two"
simulation.model = "matrix"
expect.half_turns = { min = 1 }
)";

class PanelCommands : public ProgramTest {
 protected:
  PanelCommands() { write("pair.toml", kPair); }
};

TEST_F(PanelCommands, RenderReportsEachPanel) {
  const ChildResult result = run({"render", "pair.toml", "--no-png"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, HasSubstr("out/pair.mp4, out/pair_one.csv, out/pair_two.csv, "
                                       "out/pair.json and out/pair.poster.png\n"));
  EXPECT_THAT(withoutDistances(result.output),
              EndsWith("  one:\n"
                       "  met      half_turns: expected at most 0; measured 0\n"
                       "  two:\n"
                       "  not met  half_turns: expected at least 1; measured 0\n"));
  EXPECT_EQ(countOf(" degrees of the exact motion\n", result.output), 2);
  EXPECT_THAT(files(), IsSupersetOf({"out/pair.mp4", "out/pair_one.csv", "out/pair_two.csv"}));
}

TEST_F(PanelCommands, SimulateWritesATableEach) {
  const ChildResult result = runWithoutGraphics(
      {"simulate", "pair.toml", "--csv", "t.csv", "--set", "panel.1.expect.half_turns={max=0}"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output,
              HasSubstr("pair: Pair\n  wrote t_one.csv, 12 rows\n  wrote t_two.csv, 12 rows\n"));
  EXPECT_THAT(files(), ElementsAre("pair.toml", "t_one.csv", "t_two.csv"));
}

TEST_F(PanelCommands, SimulateHasNoOneTableToPrint) {
  const ChildResult result = runWithoutGraphics({"simulate", "pair.toml", "--csv", "-"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.output, IsEmpty());
  EXPECT_EQ(result.error,
            "rotatebook: --csv -: pair has panels, each with a table of its own; name a file\n");
}

TEST_F(PanelCommands, CheckFindsWhatIsWrongWithAPanel) {
  EXPECT_EQ(runWithoutGraphics({"check", "pair.toml"}).output, "pair.toml: ok\n");
  const ChildResult result =
      runWithoutGraphics({"check", "pair.toml", "--set", "panel.1.clip.duration=3"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.error, HasSubstr("a panel has no clip of its own"));
}

TEST_F(PanelCommands, CheckFindsLabelsThatRenderRefuses) {
  const auto expectBothRefuse = [&](const std::vector<std::string>& words,
                                    const std::string& message) {
    for (std::vector<std::string> arguments : {std::vector<std::string>{"check"}, {"render"}}) {
      arguments.insert(arguments.end(), words.begin(), words.end());
      const ChildResult result = run(arguments);
      EXPECT_EQ(result.status, 2) << arguments.front();
      EXPECT_THAT(result.error, HasSubstr(message)) << arguments.front();
    }
  };
  write("odd.toml", std::string(kPair) + "[[panel]]\nlabel = \"漢\"\n");
  expectBothRefuse({"odd.toml"}, "odd.toml:15:9: the font Inter lacks \"漢\"");
  write("tall.toml", std::string(kPair) + "[[panel]]\nlabel = \"" + std::string(100, 'W') + "\"\n");
  expectBothRefuse({"tall.toml", "--size", "640x360"}, "tall.toml:15:9: the label \"WWW");
  const std::string longName(190, 'x');
  write(longName + ".toml", std::string(kPair) + "[[panel]]\nlabel = \"a long label\"\n");
  expectBothRefuse(
      {longName + ".toml"},
      "bytes; the limit is 200: rename the scene's file, or shorten the panel's label");
}

TEST_F(PanelCommands, StillDrawsAllPanels) {
  const ChildResult result = run({"still", "pair.toml", "--time", "0.1", "-o", "a.png"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(files(), Contains("a.png"));
}

TEST_F(PanelCommands, StudyHasNoOneMotion) {
  const ChildResult result = runWithoutGraphics({"study", "pair.toml"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.error,
            "rotatebook: pair.toml:7:1: a study needs a single motion, but this scene has several, "
            "panels or a grid\n");
}

// pair writes pair_one.csv for its first panel.
TEST_F(PanelCommands, RefuseASceneNamedAsAPanelsTable) {
  write("pair_one.toml", kTiny);
  const ChildResult result = run({"render", "pair.toml", "pair_one.toml"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.error,
            "rotatebook: pair and pair_one both write pair_one.csv; they would overwrite each "
            "other: render them into different folders\n");
}

}  // namespace
}  // namespace rotatebook::cli::testing
