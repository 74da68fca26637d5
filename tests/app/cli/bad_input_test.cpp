// Wrong input, case by case: the exact message, exit status 2, and nothing written.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "cli/program_test.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::IsEmpty;

/// Commands, each with the message that refuses it; ROTATEBOOK_UPDATE_GOLDENS=1 writes them anew.
const std::filesystem::path kRefusals =
    std::filesystem::path(ROTATEBOOK_TEST_DATA) / "refusals.txt";
constexpr std::string_view kPrompt = "$ rotatebook ";

class BadInput : public ProgramTest {
 protected:
  /// Returns what the program says to a command in the shell's words; expects that it writes
  /// nothing.
  std::string refusalOf(const std::string& words) const {
    SCOPED_TRACE(words);
    const ChildResult result = runWords(words);
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_THAT(files(), IsEmpty());
    return result.error;
  }
};

TEST_F(BadInput, IsRefusedByTheMessagesOfTheFileAndNothingWritten) {
  std::ifstream file(kRefusals);
  std::string expected, actual;
  for (std::string line; std::getline(file, line); expected += line + '\n') {
    if (!line.starts_with(kPrompt)) continue;
    actual += (actual.empty() ? "" : "\n") + line + '\n' + refusalOf(line.substr(kPrompt.size()));
  }
  if (std::getenv("ROTATEBOOK_UPDATE_GOLDENS")) std::ofstream(kRefusals) << actual;
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(actual, expected);
}

/// Tests of scene files that are wrong in themselves.
class BadScene : public ProgramTest {
 protected:
  void expectRefused(const std::string& scene, const std::string& message) const {
    write("tiny.toml", scene);
    for (const char* command : {"render", "check"}) {
      const ChildResult result = run({command, "tiny.toml"});
      EXPECT_EQ(result.status, 2) << command;
      EXPECT_EQ(result.error, "rotatebook: tiny.toml" + message + "\n") << command;
      EXPECT_THAT(files(), IsEmpty()) << command;
    }
  }
};

TEST_F(BadScene, NamesLineAndColumn) {
  expectRefused(std::string(kTiny) + "[body]\n  mas = 2\n",
                ":8:3: unknown key \"mas\" in [body]; did you mean \"mass\"?");
  expectRefused(
      std::string(kTiny) + "[body]\nmass = 'heavy'\n",
      ":8:8: body.mass must be a mass from 1e-9 to 1e9 kg, not \"heavy\"; a text is a number and a "
      "unit, \"kg\" or \"g\", such as \"1.5 kg\"");
}

TEST_F(BadScene, NeedsExactlyOneSpin) {
  expectRefused("title = 'T'\n[initial]\ntilt = [0.1, 'z']\n",
                ":2:1: [initial] needs angular_velocity or angular_momentum");
  expectRefused("[initial]\nangular_velocity = [0, 0, 1]\nangular_momentum = [0, 0, 1]\n",
                ":1:1: [initial] has both angular_velocity and angular_momentum; keep one of them");
}

TEST_F(BadInput, TexturesThatAreCorruptAreNamed) {
  write("cut.png", "\x89PNG\r\n\x1a\n");
  const ChildResult result = run({"render", "tiny.toml", "--set", "book.spine=cut.png"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.error,
            "rotatebook: --set book.spine=cut.png: can't read cut.png: corrupt PNG: the file ends "
            "too early\n");
  EXPECT_THAT(files(), ::testing::ElementsAre("cut.png"));
}

TEST_F(BadScene, HasANameThatNoFileMayHave) {
  const std::string dot = " begins with a dot, as names of hidden files do; rename the file\n";
  const std::string line = " isn't a line of UTF-8 without control characters; rename the file\n";
  for (const auto& [file, problem] : std::vector<std::pair<std::string, std::string>>{
           {"..toml", "..toml: the scene's name \".\"" + dot},
           {".bashrc.toml", ".bashrc.toml: the scene's name \".bashrc\"" + dot},
           {"a\xff.toml", "a\uFFFD.toml: the scene's name \"a\uFFFD\"" + line},
           {"a\nb.toml", "a\\nb.toml: the scene's name \"a\\nb\"" + line},
           {"a\u009b2Kb.toml", "a\\u009B2Kb.toml: the scene's name \"a\\u009B2Kb\"" + line},
           {"a\u202eb.toml", "a\\u202Eb.toml: the scene's name \"a\\u202Eb\"" + line}}) {
    write(file, kTiny);
    const ChildResult result = run({"render", file});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.error, "rotatebook: " + problem);
    std::filesystem::remove(folder() / file);
    EXPECT_THAT(files(), IsEmpty());
  }
}

class BadFrames : public ProgramTest {
 protected:
  BadFrames() { run({"render", "tiny.toml", "--no-mp4"}); }

  void expectRefused(const std::vector<std::string>& options, const std::string& message) const {
    std::vector<std::string> arguments{"assemble", "out/tiny", "-o", "x.mp4"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto before = files();
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.error, "rotatebook: " + message + "\n");
    EXPECT_EQ(files(), before);
  }
};

TEST_F(BadFrames, OfDifferingSizes) {
  run({"still", "tiny.toml", "--time", "0", "-o", "small.png", "--size", "32x18"});
  std::filesystem::rename(folder() / "small.png", folder() / "out/tiny/frame_00005.png");
  std::filesystem::remove(folder() / "out/tiny/frames.xxh128");
  expectRefused({},
                "frames differ in size: out/tiny/frame_00000.png is 64x36, "
                "out/tiny/frame_00005.png is 32x18");
}

TEST_F(BadFrames, WithAGap) {
  std::filesystem::remove(folder() / "out/tiny/frame_00003.png");
  expectRefused({}, "out/tiny: frame_00003.png is missing; frame_00004.png comes next");
}

TEST_F(BadFrames, OfTwoRates) {
  expectRefused({"--fps", "60"},
                "out/tiny/scene.toml sets the frame rate already; leave --fps out");
}

TEST_F(BadFrames, OfNoRate) {
  std::filesystem::remove(folder() / "out/tiny/scene.toml");
  expectRefused({}, "out/tiny has no scene.toml that sets the frame rate; give it with --fps");
}

}  // namespace
}  // namespace rotatebook::cli::testing
