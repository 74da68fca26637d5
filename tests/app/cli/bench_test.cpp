// `rotatebook bench`.
#include <csignal>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class BenchCommand : public ProgramTest {
 protected:
  /// With its temporary files in the test's own folder.
  ChildResult bench(std::vector<std::string> arguments, ChildSettings settings = {}) const {
    arguments.insert(arguments.begin(), "bench");
    settings.environment.emplace_back("TMPDIR", folder().string());
    return run(arguments, settings);
  }
};

TEST_F(BenchCommand, MeasuresASceneAndLeavesNothing) {
  const ChildResult result = bench({"tiny.toml", "--frames", "9"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output,
              AllOf(StartsWith("tiny: 9 frames, 64x36, PNGs and MP4\n  renderer "),
                    HasSubstr("\n  draw the book "), HasSubstr("\n  convert and encode "),
                    HasSubstr("\n  limit: "), HasSubstr("\n  what limits: ")));
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(BenchCommand, HasASceneOfItsOwn) {
  const ChildResult result = bench({"--frames", "2", "--size", "320x180", "--json"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, AllOf(StartsWith("{\"scene\":\"builtin\",\"frames\":2,\"width\":320,"),
                                   EndsWith("}}\n")));
  EXPECT_EQ(countOf("\n", result.output), 1);
}

TEST_F(BenchCommand, RefusesWhatIsWrong) {
  const ChildResult size = bench({"--size", "321x180"});
  EXPECT_EQ(size.status, 2);
  EXPECT_THAT(size.error, StartsWith("rotatebook: --size 321x180: clip.size"));
  const ChildResult transparent = bench({"tiny.toml", "--set", "look.background=transparent"});
  EXPECT_EQ(transparent.status, 2);
  EXPECT_EQ(transparent.error,
            "rotatebook: tiny: the MP4 that is measured can't hold the transparent background of "
            "look.background; add --set look.background=studio\n");
  EXPECT_EQ(bench({"--frames", "0"}).status, 2);
  EXPECT_EQ(bench({"missing.toml"}).status, 2);
  EXPECT_EQ(bench({"--set", "clip.sise=1"}).status, 2);
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(BenchCommand, IsThreeOnAMachineThatCanNot) {
  const ChildResult result = runWithoutGraphics({"bench", "tiny.toml"});
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.error, HasSubstr("rotatebook: can't draw: "));
}

TEST_F(BenchCommand, LeavesNothingWhenInterrupted) {
  ChildSettings settings;
  settings.signal = SIGINT;
  settings.signalWhen = [this] { return !files().empty(); };
  const ChildResult result = bench({"tiny.toml", "--frames", "100000"}, settings);
  EXPECT_EQ(result.status, 130);
  EXPECT_EQ(result.output, "tiny: interrupted; nothing was measured\n");
  EXPECT_THAT(files(), IsEmpty());
}

}  // namespace
}  // namespace rotatebook::cli::testing
