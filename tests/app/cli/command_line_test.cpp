// Answers about the command line itself: version, help, and words that mean nothing.
#include <sstream>
#include <string>
#include <vector>

extern "C" {
#include <libavformat/version.h>
}

#include "base/version.h"
#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
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

class HelpText : public ProgramTest {
 protected:
  /// Returns the names of the commands, as the program's own help lists them.
  std::vector<std::string> commands() {
    std::istringstream help(run({"--help"}).output);
    std::vector<std::string> names;
    bool isList = false;
    for (std::string line; std::getline(help, line);) {
      if (line == "Commands:") isList = true;
      if (line.empty()) isList = false;
      // A command's line has its name two columns in; what is deeper goes on with its description.
      if (isList && line.starts_with("  ") && line[2] != ' ') {
        names.push_back(line.substr(2, line.find(' ', 2) - 2));
      }
    }
    return names;
  }
};

TEST_F(HelpText, ListsTheCommands) {
  EXPECT_THAT(commands(), IsSupersetOf({"render", "map", "submit", "judge", "toss", "page"}));
}

TEST_F(HelpText, ShowsAnExampleOfEachCommand) {
  for (const std::string& command : commands()) {
    SCOPED_TRACE(command);
    const ChildResult result = run({command, "--help"});
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.error, IsEmpty());
    EXPECT_THAT(result.output, HasSubstr("\nUsage: rotatebook " + command + " "));
    EXPECT_THAT(result.output, ContainsRegex("\n  rotatebook " + command + "[ \n]"));
    EXPECT_EQ(run({"help", command}).output, result.output);
  }
}

TEST_F(CommandLine, PrintsTheVersion) {
  for (const char* way : {"--version", "-v", "-V"}) {
    const ChildResult result = run({way});
    EXPECT_EQ(result.status, 0) << way;
    EXPECT_EQ(result.output, "rotatebook " + std::string(kVersion) + "\n") << way;
  }
}

TEST_F(CommandLine, HelpNamesCommandsExamplesAndExitStatus) {
  const ChildResult result = run({"--help"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output, AllOf(HasSubstr("\n  rotatebook render scenes/starter.toml\n"),
                                   HasSubstr("\nExit status: 0 done; 1 ")));
  EXPECT_EQ(run({"help"}).output, result.output);
}

TEST_F(CommandLine, HelpHasGroups) {
  const std::string render = run({"help", "render"}).output;
  std::size_t last = 0;
  for (const char* group : {"\n\nOptions:\n", "\n\nClip:\n  --frames", "\n\nScene:\n  --set",
                            "\n\nDevice:\n  --device", "\n\nEvery command:\n  -h,--help"}) {
    const std::size_t at = render.find(group);
    ASSERT_NE(at, std::string::npos) << group;
    EXPECT_GE(at, last) << group;
    last = at;
  }
  EXPECT_THAT(render, Not(HasSubstr("\n\n\n")));
}

TEST_F(CommandLine, OptionsOfPicturesAreHiddenWhereNothingIsDrawn) {
  for (const char* command : {"simulate", "study", "info"}) {
    EXPECT_THAT(run({"help", command}).output, AllOf(HasSubstr("--set"), Not(HasSubstr("--size")),
                                                     Not(HasSubstr("--allow-outside"))));
  }
  EXPECT_THAT(run({"help", "check"}).output,
              AllOf(HasSubstr("--size"), HasSubstr("--allow-outside")));
  EXPECT_EQ(run({"simulate", "tiny.toml", "--size", "32x18", "--allow-outside"}).status, 0);
}

TEST_F(CommandLine, NeedsACommand) {
  const ChildResult result = run({});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.error,
              AllOf(StartsWith("rotatebook: a command is needed, for example: rotatebook render "),
                    HasSubstr("\nCommands: render, simulate, "),
                    HasSubstr("\nRun 'rotatebook --help' for more information.\n")));
  EXPECT_THAT(result.output, IsEmpty());
}

TEST_F(CommandLine, OnlyTheLastOfARepeatedOptionCounts) {
  const std::vector<std::vector<std::string>> wrongFirst{
      {"still", "tiny.toml", "-o", "-", "-o", "s.png", "--count", "x", "--count", "1"},
      {"diff", "s.png", "s.png", "--max", "x", "--max", "300", "--max", "2"},
      {"render", "tiny.toml", "--no-png", "--jobs", "x", "-j", "0", "--jobs", "1"},
      {"still", "tiny.toml", "-o", "t.png", "--time", "noon", "--time", "0"}};
  for (const std::vector<std::string>& arguments : wrongFirst) {
    EXPECT_EQ(run(arguments).status, 0) << run(arguments).error;
  }
  const ChildResult wrongLast = run({"render", "tiny.toml", "--jobs", "1", "--jobs", "65"});
  EXPECT_EQ(wrongLast.status, 2);
  EXPECT_THAT(wrongLast.error, HasSubstr("--jobs"));
}

TEST_F(CommandLine, SuggestsTheNearestCommand) {
  const std::string advice = "\nRun 'rotatebook --help' for more information.\n";
  expectRefused({"redner", "tiny.toml"},
                "rotatebook: unknown command: redner; did you mean \"render\"?" + advice);
  expectRefused({"spin", "tiny.toml"},
                "rotatebook: unknown command: spin; did you mean \"info\"?" + advice);
  expectRefused({"xyz"}, "rotatebook: unknown command: xyz" + advice);
  expectRefused({"tiny.toml"},
                "rotatebook: unknown command: tiny.toml; it is a scene: rotatebook render "
                "tiny.toml" +
                    advice);
  expectRefused({"a\nb\x1b[2J"}, "rotatebook: unknown command: a\\nb\\u001B[2J" + advice);
  expectRefused({"help", "stil"}, "rotatebook: unknown command: stil; did you mean \"still\"?\n");
}

/// A wrong command line, and what the program says about it.
struct WrongOption {
  std::string name;
  std::vector<std::string> arguments;
  std::string message;
};

class UnknownOption : public CommandLine, public ::testing::WithParamInterface<WrongOption> {};

TEST_P(UnknownOption, IsNamedWithTheNearest) {
  const auto& [name, arguments, message] = GetParam();
  // " of render: --sise" names the command.
  const std::size_t colon = message.find(':');
  const std::string command = colon > 0 ? message.substr(4, colon - 4) + ' ' : "";
  expectRefused(arguments, "rotatebook: unknown option" + message + "\nRun 'rotatebook " + command +
                               "--help' for more information.\n");
}

INSTANTIATE_TEST_SUITE_P(
    Cases, UnknownOption,
    ::testing::Values(
        WrongOption{"OfTheCommand",
                    {"render", "tiny.toml", "--sise", "64x36"},
                    " of render: --sise; did you mean \"--size\"?"},
        WrongOption{"WithItsValue",
                    {"render", "tiny.toml", "--sise=64x36"},
                    " of render: --sise; did you mean \"--size\"?"},
        WrongOption{"WithOneDash",
                    {"render", "-size", "64x36", "tiny.toml"},
                    " of render: -size; did you mean \"--size\"?"},
        WrongOption{"RatherThanAMissingOne",
                    {"still", "tiny.toml", "--ouput", "x.png", "--count", "2"},
                    " of still: --ouput; did you mean \"--output\"?"},
        WrongOption{"OfAnotherCommand",
                    {"still", "tiny.toml", "--no-png"},
                    " of still: --no-png; it is an option of render and submit"},
        WrongOption{"OfSeveralCommands",
                    {"check", "tiny.toml", "--no-expect"},
                    " of check: --no-expect; it is an option of render and simulate"},
        WrongOption{"BeforeTheCommand",
                    {"--size", "64x36", "render", "tiny.toml"},
                    " of render: --size; it comes after the command: rotatebook render ... --size"},
        WrongOption{"Abbreviated",
                    {"render", "tiny.toml", "--out", "x"},
                    " of render: --out; did you mean \"--output\"?"},
        WrongOption{"NotByItsDashes", {"check", "tiny.toml", "--out", "x"}, " of check: --out"},
        WrongOption{"InOtherWords",
                    {"still", "tiny.toml", "--at", "3"},
                    " of still: --at; did you mean \"--time\"?"},
        WrongOption{"AKeyOfScenes",
                    {"render", "tiny.toml", "--fps", "30"},
                    " of render: --fps; it is a key of scenes: --set clip.fps=..."},
        WrongOption{"WithoutACommand", {"--sise"}, ": --sise"},
        WrongOption{"OneLetter", {"render", "tiny.toml", "-z"}, " of render: -z"},
        WrongOption{"NothingNear", {"render", "tiny.toml", "--xyz"}, " of render: --xyz"},
        WrongOption{
            "Unprintable", {"render", "tiny.toml", "--x\x1b[2J"}, " of render: --x\\u001B[2J"},
        WrongOption{"AFile",
                    {"render", "-x.toml"},
                    " of render: -x.toml; a file whose name begins with a dash is written "
                    "./-x.toml"},
        WrongOption{"AClip",
                    {"verify", "-x.mp4"},
                    " of verify: -x.mp4; a file whose name begins with a dash is written "
                    "./-x.mp4"},
        WrongOption{"APicture",
                    {"diff", "-x.png", "y.png"},
                    " of diff: -x.png; a file whose name begins with a dash is written "
                    "./-x.png"}),
    [](const auto& one) { return one.param.name; });

TEST_F(CommandLine, HintsAtAFileThatIsTakenForAnOption) {
  write("-o.toml", kTiny);
  EXPECT_THAT(run({"check", "-o.toml"}).error,
              HasSubstr("; a file whose name begins with a dash is written ./-o.toml\n"));
  EXPECT_EQ(run({"check", "./-o.toml"}).status, 0);
}

TEST_F(CommandLine, RefusesWhatIsTooMuchOrMissing) {
  const std::string advice = " --help' for more information.\n";
  expectRefused({"render"}, "rotatebook: SCENE is required\nRun 'rotatebook render" + advice);
  expectRefused({"toss", "tiny.csv", "b.csv"},
                "rotatebook: unexpected argument: b.csv\n"
                "Run 'rotatebook toss" +
                    advice);
  expectRefused({"doctor", "x"},
                "rotatebook: unexpected argument: x\n"
                "Run 'rotatebook doctor" +
                    advice);
  expectRefused({"render", "tiny.toml", "--size"},
                "rotatebook: --size needs a value: --size WxH\nRun 'rotatebook render" + advice);
  expectRefused({"verify", "x.mp4", "--all", "--frames", "0"},
                "rotatebook: --frames excludes --all\n"
                "Run 'rotatebook verify" +
                    advice);
  expectRefused({"diff", "a.png"}, "rotatebook: B is required\nRun 'rotatebook diff" + advice);
}

TEST_F(CommandLine, WritesNoResultToTheStandardOutput) {
  for (const std::string command : {"export", "map"}) {
    expectRefused({command, "tiny.toml", "-o", "-"},
                  "rotatebook: --output: nothing is written to the standard output; a file or "
                  "folder named - is written ./-\nRun 'rotatebook " +
                      command + " --help' for more information.\n");
  }
}

TEST_F(CommandLine, RefusesWrongNumbers) {
  expectRefused({"still", "tiny.toml", "--time", "noon", "-o", "x.png"},
                "rotatebook: --time must be a number, not \"noon\"\n"
                "Run 'rotatebook still --help' for more information.\n");
  expectRefused({"still", "tiny.toml", "--time", "0.1,0.2", "-o", "x.png"},
                "rotatebook: --time must be a number, not \"0.1,0.2\"; --times takes several\n"
                "Run 'rotatebook still --help' for more information.\n");
  expectRefused({"render", "tiny.toml", "--jobs", "0"},
                "rotatebook: --jobs must be a whole number from 1 to 64, not 0\n"
                "Run 'rotatebook render --help' for more information.\n");
  expectRefused({"diff", "a.png", "b.png", "--max", "256"},
                "rotatebook: --max must be a whole number from 0 to 255, not 256\n"
                "Run 'rotatebook diff --help' for more information.\n");
}

TEST_F(CommandLine, RefusesWrongWords) {
  expectRefused({"judge", "a.csv", "--rates", "deg"},
                "rotatebook: --rates must be rad/s or deg/s, not \"deg\"; did you mean \"deg/s\"?\n"
                "Run 'rotatebook judge --help' for more information.\n");
  expectRefused({"check", "tiny.toml", "--progress", "x"},
                "rotatebook: --progress must be bar, json or none, not \"x\"\n"
                "Run 'rotatebook check --help' for more information.\n");
}

// Each command's first argument is read from the standard input, or refused with the remedy.
TEST_F(CommandLine, KnowsTheStandardInput) {
  const std::string refusal =
      ": the standard input isn't read here; name a file or folder; one that is named - is written "
      "./-\n";
  for (const auto& [words, name] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"verify", "-"}, "CLIP"},
           {{"watch", "-"}, "SCENE"},
           {{"page", "-"}, "SCENE"},
           {{"submit", "render", "-", "--plan", "list"}, "SCENE"},
           {{"status", "-"}, "DIR"},
           {{"assemble", "-", "-o", "x.mp4"}, "DIR"},
           {{"diff", "-", "a.png"}, "A"},
           {{"diff", "a.png", "-"}, "B"}}) {
    expectRefused(words, "rotatebook: " + name + refusal + "Run 'rotatebook " + words.front() +
                             " --help' for more information.\n");
  }
  for (const std::string command :
       {"simulate", "info", "judge", "check", "export", "still", "study"}) {
    const ChildResult result = runWords(command + " - < tiny.toml");
    EXPECT_EQ(result.status, 0) << command << result.error;
    EXPECT_THAT(result.output, HasSubstr("stdin")) << command;
    EXPECT_THAT(runWords(command + " - < /dev/null").error,
                StartsWith("rotatebook: stdin: can't be read: it is empty, or was read already\n"));
  }
}

TEST_F(CommandLine, TheLastOfARepeatedOptionWins) {
  const std::vector<std::string> words{"check", "--print", "tiny.toml", "--size",
                                       "64x64", "--size",  "32x18"};
  EXPECT_THAT(run(words).output, HasSubstr("\nsize = [32, 18]"));
  EXPECT_EQ(
      run({"still", "tiny.toml", "--time", "0", "--time", "0.1", "-o", "a.png", "-o", "b.png"})
          .output,
      "tiny: wrote frame 6 to b.png\n");
  EXPECT_THAT(files(), ElementsAre("b.png"));
}

TEST_F(CommandLine, RepeatedOverridesAllCount) {
  const ChildResult result = run({"check", "--print", "tiny.toml", "--set", "body.mass=2", "--set",
                                  "clip.duration=0.3", "--set", "body.mass=3"});
  EXPECT_THAT(result.output, AllOf(HasSubstr("\nmass = 3.0"), HasSubstr("\nduration = 0.3")));
}

TEST_F(CommandLine, LoadsFfmpegOnlyForVideos) {
  const std::string library = "libavformat.so." AV_STRINGIFY(LIBAVFORMAT_VERSION_MAJOR);
  write(library, "no library");
  const ChildSettings broken{.folder = folder(),
                             .environment = {{"LD_LIBRARY_PATH", folder().string()}}};
  EXPECT_EQ(run({"check", "tiny.toml"}, broken).status, 0);
  for (const char* part : {"1/2", "2/2"}) {
    const ChildResult drawn = run({"render", "tiny.toml", "-o", "parts", "--part", part}, broken);
    EXPECT_EQ(drawn.status, 0) << drawn.error;
  }
  const std::vector<std::string> frames{"render", "tiny.toml", "-o",
                                        "parts",  "--no-mp4",  "--resume"};
  EXPECT_EQ(run(frames, broken).status, 0);
  EXPECT_TRUE(has("parts/tiny/frame_00011.png"));
  const ChildResult result = run({"render", "tiny.toml", "-o", "out"}, broken);
  EXPECT_EQ(result.status, 3);
  EXPECT_THAT(result.error, AllOf(HasSubstr("rotatebook: can't load FFmpeg: "), HasSubstr(library),
                                  HasSubstr("; install the version that the program was built")));
}

}  // namespace
}  // namespace rotatebook::cli::testing
