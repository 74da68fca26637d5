// Progress as the user sees it: a bar on a terminal, plain lines elsewhere.
#include <csignal>
#include <string>

#include "base/json.h"
#include "cli/program_test.h"
#include "lacking.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::Not;

using ProgressOfARender = ProgramTest;

TEST_F(ProgressOfARender, IsABarOnATerminal) {
  ROTATEBOOK_SKIP_IF_LACKING(whyNoTerminal());
  ChildSettings settings;
  settings.terminal = true;
  const ChildResult result =
      run({"render", "tiny.toml", "--no-png", "--set", "clip.duration=4"}, settings);
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(
      result.error,
      AllOf(ContainsRegex("\rtiny  \\[#*\\.*\\] +[0-9]+ %  [0-9]+/240 frames, [0-9]+\\.[0-9] "
                          "frames/s, [0-9]+ s left\x1b\\[K"),
            HasSubstr("\rtiny  [################] 100 %  240/240 frames, "),
            EndsWith(" s left\x1b[K\r\n")));
  EXPECT_EQ(countOf("\n", result.error), 1);
  EXPECT_THAT(result.output, Not(HasSubstr("\r")));
}

TEST_F(ProgressOfARender, KeepsTheTimeLeftOnANarrowTerminal) {
  ROTATEBOOK_SKIP_IF_LACKING(whyNoTerminal());
  ChildSettings settings;
  settings.terminal = true;
  settings.columns = 40;
  const ChildResult result =
      run({"render", "tiny.toml", "--no-png", "--set", "clip.duration=4"}, settings);
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.error, ContainsRegex("\rtiny  \\[#+\\] 100 %, [0-9]+ s left\x1b\\[K\r\n$"));
  EXPECT_THAT(result.error, Not(ContainsRegex("\r[^\r]{40,}\x1b")));
}

TEST_F(ProgressOfARender, CutsALongNameBetweenItsLetters) {
  ROTATEBOOK_SKIP_IF_LACKING(whyNoTerminal());
  ChildSettings settings;
  settings.terminal = true;
  settings.columns = 40;
  const std::string name = "漢字漢字漢字漢字";
  write(name + ".toml", kTiny);
  const ChildResult result = run({"render", name + ".toml", "--no-png"}, settings);
  EXPECT_EQ(result.status, 0);
  // 13 columns of 39.
  EXPECT_THAT(result.error, HasSubstr("\r漢字漢字漢字…  [####"));
}

TEST_F(ProgressOfARender, IsLinesOfJsonOnRequest) {
  const ChildResult result = run({"render", "tiny.toml", "--no-png", "-q", "--progress", "json"});
  EXPECT_EQ(result.status, 0);
  ASSERT_THAT(result.error, EndsWith("}\n"));
  const auto last =
      Json::parse(result.error.substr(result.error.rfind('\n', result.error.size() - 2) + 1));
  EXPECT_EQ(last["progress"], "tiny");
  EXPECT_EQ(last["done"], 12);
  EXPECT_EQ(last["total"], 12);
  EXPECT_EQ(last["unit"], "frames");
}

TEST_F(ProgressOfARender, IsFollowedByLinesInColourThatFitTheTerminal) {
  ROTATEBOOK_SKIP_IF_LACKING(whyNoTerminal());
  const auto errorWith = [this](const char* noColour) {
    ChildSettings settings;
    settings.terminal = true;
    settings.columns = 40;
    settings.environment = {{"NO_COLOR", noColour}, {"TERM", "xterm"}};
    return run({"simulate", "missing-scene-of-a-name.toml", "--no-expect"}, settings).error;
  };
  EXPECT_EQ(errorWith(""),
            "\x1b[1;31mrotatebook:\x1b[m\r\nmissing-scene-of-a-name.toml: scene not\r\nfound\r\n");
  EXPECT_EQ(errorWith("1"), "rotatebook:\r\nmissing-scene-of-a-name.toml: scene not\r\nfound\r\n");
}

TEST_F(ProgressOfARender, IsSilentOfAShortOneWithoutATerminal) {
  EXPECT_THAT(run({"render", "tiny.toml", "--no-png", "--no-mp4"}).error, IsEmpty());
}

TEST_F(ProgressOfARender, IsPlainLinesWithoutATerminal) {
  ChildSettings settings;
  settings.signal = SIGINT;
  settings.signalUpon = "\n";
  const ChildResult result = run({"render", "tiny.toml", "--no-png", "--size", "640x360", "--set",
                                  "clip.duration=1000", "--set", "simulation.substeps=1"},
                                 settings);
  EXPECT_EQ(result.status, 130);
  EXPECT_THAT(result.error,
              MatchesRegex("(tiny  \\[#*\\.*\\] +[0-9]+ %  [0-9]+/60000 frames, [0-9]+\\.[0-9] "
                           "frames/s, [0-9]+ s left\n)+"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
