// Progress as the user sees it: a bar on a terminal, plain lines elsewhere.
#include <csignal>
#include <string>

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
