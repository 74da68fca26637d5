// Scenes from strangers: they reach nothing outside their folder and run nothing.
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <vector>

#include "cli/program_test.h"
#include "messages.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kOutside =
    "it leads outside the scene's folder, which --allow-outside allows\n";

/// Words that a shell or a terminal might obey.
constexpr const char* kWordsOfCommands = R"toml(
title = "'; system('touch ran') # `touch ran` $(touch ran)"
caption = "\n!touch ran\n"
book.color = "#2b5d8a"
[initial]
angular_velocity = [5.0, 0.0, 0.0]
[clip]
size = [64, 36]
duration = 0.2
[study]
x = { key = "simulation.substeps", values = [1, 2] }
)toml";

/// scenes/a.toml with a picture beside it, and one in the folder above.
class HostileScene : public ProgramTest {
 protected:
  HostileScene() {
    write("scenes/a.toml", kTiny);
    run({"still", "tiny.toml", "--time", "0", "-o", "outside.png"});
    fs::copy_file(folder() / "outside.png", folder() / "scenes/inside.png");
  }

  ChildResult check(const std::string& texture, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"check", "scenes/a.toml", "--set", "book.front=" + texture};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  void expectRefused(const std::string& texture) const {
    const ChildResult result = check(texture);
    EXPECT_EQ(result.status, 2) << texture;
    EXPECT_EQ(result.error, "rotatebook: --set book.front=" + texture + ": can't read scenes/" +
                                texture + ": " + kOutside);
    EXPECT_EQ(check(texture, {"--allow-outside"}).status, 0) << texture;
  }
};

TEST_F(HostileScene, TakesTexturesFromItsFolder) {
  EXPECT_EQ(check("inside.png").status, 0);
  EXPECT_EQ(check("./inside.png").status, 0);
  EXPECT_EQ(check("../scenes/inside.png").status, 0);
  fs::create_directories(folder() / "scenes/covers");
  EXPECT_EQ(check("covers/../inside.png").status, 0);
}

TEST_F(HostileScene, ReachesNothingAboveItsFolder) {
  expectRefused("../outside.png");
  fs::create_directories(folder() / "scenes/covers");
  expectRefused("covers/../../outside.png");
  fs::create_directories(folder() / "scenes2");
  fs::copy_file(folder() / "outside.png", folder() / "scenes2/b.png");
  expectRefused("../scenes2/b.png");
}

TEST_F(HostileScene, ReachesNothingThroughLinks) {
  fs::create_symlink("../outside.png", folder() / "scenes/link.png");
  expectRefused("link.png");
  fs::create_directory_symlink("..", folder() / "scenes/up");
  expectRefused("up/outside.png");
  fs::create_symlink("inside.png", folder() / "scenes/within.png");
  EXPECT_EQ(check("within.png").status, 0);
}

TEST_F(HostileScene, TakesNoWordsFromOutsideItsFolder) {
  write("outside.words", "Energy = \"Secret\"\n");
  fs::create_symlink("../outside.words", folder() / "scenes/link.words");
  for (const char* words : {"../outside.words", "link.words"}) {
    const std::vector<std::string> arguments{"check", "--print", "scenes/a.toml", "--set",
                                             std::string("overlay.words=") + words};
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, 2) << words;
    EXPECT_MESSAGE(result.error) << words;
    EXPECT_THAT(result.output, IsEmpty()) << words;
  }
}

TEST_F(HostileScene, MayLieInALinkedFolderItself) {
  fs::create_directory_symlink("scenes", folder() / "linked");
  EXPECT_EQ(run({"check", "linked/a.toml", "--set", "book.front=inside.png"}).status, 0);
}

TEST_F(HostileScene, IsRefusedByEveryCommandThatDraws) {
  const std::vector<std::string> wrong{"--set", "book.front=../outside.png"};
  for (std::vector<std::string> arguments :
       {std::vector<std::string>{"render", "scenes/a.toml"},
        {"still", "scenes/a.toml", "--time", "0", "-o", "x.png"},
        {"still", "scenes/a.toml", "-o", "x.png", "--count", "2"},
        {"bench", "scenes/a.toml", "--frames", "2"}}) {
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments.front();
    EXPECT_MESSAGE(result.error) << arguments.front();
    EXPECT_THAT(result.output, IsEmpty()) << arguments.front();
    EXPECT_FALSE(has("x.png")) << arguments.front();
  }
}

TEST_F(HostileScene, IsAllowedOutsideByEveryCommandThatReadsTextures) {
  for (const char* command : {"render", "page", "still", "bench", "check", "verify"}) {
    EXPECT_THAT(run({command, "--help"}).output, HasSubstr("--allow-outside")) << command;
  }
}

TEST_F(HostileScene, IsNotWaitedFor) {
  ASSERT_EQ(mkfifo((folder() / "scenes/pipe.toml").c_str(), 0600), 0);
  const ChildResult scene = run({"check", "scenes/pipe.toml"});
  EXPECT_EQ(scene.error, "rotatebook: scenes/pipe.toml: can't be read: it is a pipe, not a file\n");
  ASSERT_EQ(mkfifo((folder() / "scenes/pipe.png").c_str(), 0600), 0);
  EXPECT_THAT(check("pipe.png").error, HasSubstr("it is a pipe, not a file\n"));
}

// Its words are data wherever they go: file names, plots, metadata, the terminal.
TEST_F(HostileScene, RunsNothing) {
  write("scenes/b.toml", kWordsOfCommands);
  EXPECT_EQ(run({"render", "scenes/b.toml", "--no-png"}).status, 0);
  EXPECT_EQ(run({"study", "scenes/b.toml"}).status, 0);
  EXPECT_EQ(run({"check", "scenes"}).status, 0);
  for (const std::string& file : files()) EXPECT_THAT(file, ::testing::Not(HasSubstr("ran")));
}

TEST_F(HostileScene, NamesNoFileOutsideTheOutput) {
  write("scenes/c.toml",
        std::string(kTiny) + "[[panel]]\nlabel = \"../../up\"\n[[panel]]\nlabel = \"/etc/x\"\n");
  EXPECT_EQ(run({"render", "scenes/c.toml", "--no-png", "--no-mp4"}).status, 0);
  EXPECT_TRUE(has("out/c_up.csv"));
  EXPECT_TRUE(has("out/c_etc-x.csv"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
