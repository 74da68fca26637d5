// `rotatebook render` of several scenes at a time.
#include <csignal>
#include <string>
#include <vector>

#include "cli/program_test.h"
#include "messages.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// tiny.toml, and two that differ from it.
class RenderScenes : public ProgramTest {
 protected:
  RenderScenes() {
    write("large.toml", std::string(kTiny) + "[look]\nsupersample = 2\n");
    write("panels.toml",
          "title = \"Panels\"\n[clip]\nsize = [128, 36]\nduration = 0.2\n"
          "[[panel]]\nlabel = \"a\"\ninitial.angular_velocity = [5.0, 0.0, 0.005]\n"
          "[[panel]]\nlabel = \"b\"\ninitial.angular_velocity = [0.0, 5.0, 0.0]\n");
  }

  ChildResult render(const std::string& jobs, const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"render",      "tiny.toml", "large.toml",
                                       "panels.toml", "--jobs",    jobs};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
  }
};

TEST_F(RenderScenes, AreTheSameInBytesHoweverManyGoOnAtATime) {
  const ChildResult one = render("1", {"-o", "one"}), three = render("3", {"-o", "three"});
  EXPECT_EQ(one.status, 0) << one.error;
  EXPECT_EQ(three.status, 0) << three.error;
  // Frames and what tells of them, MP4, poster, table and result; a panel's.
  EXPECT_EQ(expectSameFiles("one", "three"), 3 * (12 + 7) + 1);
}

TEST_F(RenderScenes, AreReportedWholeAndInTheirOrder) {
  const ChildResult result = render("3", {"--no-png"});
  EXPECT_THAT(result.output, StartsWith("3 scenes at a time\ntiny: Tiny\n  64x36 at "));
  const std::string output = withoutDistances(result.output);
  EXPECT_THAT(output, HasSubstr("\n  wrote out/tiny.mp4, out/tiny.csv, out/tiny.json and "
                                "out/tiny.poster.png\nlarge: Tiny\n"));
  EXPECT_THAT(output, HasSubstr("out/large.poster.png\npanels: Panels\n"));
}

TEST_F(RenderScenes, GoOnToTheirEndWhereAnotherFails) {
  fs::create_directories(folder() / "out/large.mp4");
  const ChildResult result = render("3", {});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.error,
            "large failed; no more scenes are started\n"
            "rotatebook: large: can't write out/large.mp4: it is a folder\n");
  EXPECT_THAT(result.output, AllOf(HasSubstr("tiny: Tiny\n"), HasSubstr("panels: Panels\n")));
  EXPECT_TRUE(has("out/tiny.mp4"));
  EXPECT_TRUE(has("out/panels.mp4"));
}

TEST_F(RenderScenes, ThatFailAreEachReported) {
  fs::create_directories(folder() / "out/tiny.mp4");
  fs::create_directories(folder() / "out/large.mp4");
  // Simulating takes a second, so that both are begun before either fails.
  const ChildResult result = run({"render", "tiny.toml", "large.toml", "--jobs", "2", "--set",
                                  "clip.duration=20", "--set", "simulation.substeps=2000"});
  EXPECT_EQ(result.status, 3);
  // Either may fail first, as the first line says.
  EXPECT_MESSAGE(result.error.substr(result.error.find('\n') + 1));
}

TEST_F(RenderScenes, AreNotBegunAfterAnotherFailed) {
  fs::create_directories(folder() / "out/tiny.mp4");
  const ChildResult result = run({"render", "tiny.toml", "large.toml", "panels.toml", "--jobs", "2",
                                  "--set", "clip.duration=5"});
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.output, EndsWith("panels: not started\n"));
  EXPECT_TRUE(has("out/large.mp4"));
  EXPECT_FALSE(has("out/panels.mp4"));
}

TEST_F(RenderScenes, AreAllInterrupted) {
  ChildSettings settings;
  settings.signal = SIGINT;
  settings.signalWhen = [this] {
    return has("out/tiny.partial/frame_00002.png") && has("out/large.partial/frame_00002.png");
  };
  const ChildResult result = run({"render", "tiny.toml", "large.toml", "panels.toml", "--jobs", "2",
                                  "--set", "clip.duration=200", "--set", "simulation.substeps=1"},
                                 settings);
  EXPECT_EQ(result.status, 130) << result.error;
  EXPECT_TRUE(has("out/tiny.partial.mp4"));
  EXPECT_TRUE(has("out/large.partial.mp4"));
  EXPECT_FALSE(has("out/panels.partial"));
}

TEST_F(RenderScenes, AreAtLeastOneAtATime) {
  const ChildResult result = render("0", {});
  EXPECT_EQ(result.status, 2);
  EXPECT_MESSAGE(result.error);
}

}  // namespace
}  // namespace rotatebook::cli::testing
