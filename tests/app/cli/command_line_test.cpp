// Answers about the command line itself: version, help, and words that mean nothing.
#include <string>
#include <vector>

#include "base/version.h"
#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class CommandLine : public ProgramTest {
 protected:
  /// Expects that `arguments` are refused with `message`, and that nothing is written.
  void expectRefused(const std::vector<std::string>& arguments, const std::string& message) const {
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.error, message);
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_THAT(files(), IsEmpty());
  }
};

class HelpText : public ProgramTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(HelpText, ShowsAnExampleOfTheCommand) {
  const std::string command = GetParam();
  const ChildResult result = run({command, "--help"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.error, IsEmpty());
  EXPECT_THAT(result.output, HasSubstr("\nUsage: rotatebook " + command + " "));
  EXPECT_THAT(result.output, HasSubstr("\n  rotatebook " + command + " "));
}

INSTANTIATE_TEST_SUITE_P(Commands, HelpText,
                         ::testing::Values("render", "simulate", "study", "still", "diff", "check",
                                           "scene", "assemble", "list", "doctor", "verify",
                                           "rerun"),
                         [](const auto& command) { return std::string(command.param); });

TEST_F(CommandLine, PrintsTheVersion) {
  const ChildResult result = run({"--version"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output, "rotatebook " + std::string(kVersion) + "\n");
}

TEST_F(CommandLine, HelpNamesCommandsExamplesAndExitStatus) {
  const ChildResult result = run({"--help"});
  EXPECT_EQ(result.status, 0);
  for (const char* command : {"render", "simulate", "study", "still", "diff", "check", "scene",
                              "assemble", "list", "doctor", "verify", "rerun"}) {
    EXPECT_THAT(result.output, HasSubstr("\n  " + std::string(command) + " "));
  }
  EXPECT_THAT(result.output, AllOf(HasSubstr("\n  rotatebook render scenes/starter.toml\n"),
                                   HasSubstr("\nExit status: 0 done; 1 ")));
}

TEST_F(CommandLine, NeedsACommand) {
  expectRefused({},
                "rotatebook: a command is needed, for example render\n"
                "Run 'rotatebook --help' for more information.\n");
}

TEST_F(CommandLine, RefusesAnUnknownCommand) {
  expectRefused({"rendr", "tiny.toml"},
                "rotatebook: unknown command: rendr\n"
                "Run 'rotatebook --help' for more information.\n");
  expectRefused({"--sise", "3"},
                "rotatebook: unknown option: --sise\n"
                "Run 'rotatebook --help' for more information.\n");
}

TEST_F(CommandLine, RefusesAnUnknownOption) {
  const std::string advice = "Run 'rotatebook render --help' for more information.\n";
  expectRefused({"render", "tiny.toml", "--sise", "64x36"},
                "rotatebook: The following argument was not expected: --sise\n" + advice);
  expectRefused({"render"}, "rotatebook: SCENE is required\n" + advice);
  expectRefused({"render", "tiny.toml", "--jobs", "0"},
                "rotatebook: --jobs: Value 0 not in range 1 to 64\n" + advice);
}

TEST_F(CommandLine, RefusesValuesThatAreNoNumbers) {
  expectRefused({"still", "tiny.toml", "--time", "noon", "-o", "x.png"},
                "rotatebook: Could not convert: --time = noon\n"
                "Run 'rotatebook still --help' for more information.\n");
  expectRefused({"diff", "a.png", "b.png", "--max", "256"},
                "rotatebook: --max: Value 256 not in range 0 to 255\n"
                "Run 'rotatebook diff --help' for more information.\n");
}

TEST_F(CommandLine, RefusesMissingOptions) {
  expectRefused({"simulate", "tiny.toml"},
                "rotatebook: --csv is required\n"
                "Run 'rotatebook simulate --help' for more "
                "information.\n");
  expectRefused({"still", "tiny.toml", "--time", "0"},
                "rotatebook: --output is required\n"
                "Run 'rotatebook still --help' for more information.\n");
}

}  // namespace
}  // namespace rotatebook::cli::testing
