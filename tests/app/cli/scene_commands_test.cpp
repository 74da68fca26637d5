// `rotatebook still` and `check`.
#include <filesystem>
#include <string>

#include "cli/program_test.h"
#include "image/png_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class SceneCommandsTest : public ProgramTest {};

TEST_F(SceneCommandsTest, StillIsTheFrameOfTheRender) {
  run({"render", "tiny.toml", "--no-mp4"});
  const ChildResult result = run({"still", "tiny.toml", "--time", "0.1", "-o", "x.png"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.output, "tiny: wrote frame 6 to x.png\n");
  EXPECT_EQ(image::readPng(folder() / "x.png"),
            image::readPng(folder() / "out/tiny/frame_00006.png"));
  EXPECT_FALSE(image::readPng(folder() / "x.png") ==
               image::readPng(folder() / "out/tiny/frame_00007.png"));
}

TEST_F(SceneCommandsTest, StillAtTheEndIsTheLastFrame) {
  const ChildResult result = run({"still", "tiny.toml", "--time", "0.2", "-o", "x.png", "--size",
                                  "32x18", "--set", "clip.duration=0.3"});
  EXPECT_EQ(result.output, "tiny: wrote frame 12 to x.png\n");
  EXPECT_EQ(run({"still", "tiny.toml", "--time", "0.2", "-o", "x.png"}).output,
            "tiny: wrote frame 11 to x.png\n");
}

TEST_F(SceneCommandsTest, StillIsThePosterInItsFolderByDefault) {
  run({"render", "tiny.toml", "--no-mp4"});
  const ChildResult result = run({"still", "tiny.toml"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.output, "tiny: wrote frame 6 to tiny.png\n");
  EXPECT_EQ(image::readPng(folder() / "tiny.png"),
            image::readPng(folder() / "out/tiny.poster.png"));
  EXPECT_EQ(run({"still", "out/../tiny.toml", "--set", "clip.poster=0.05"}).output,
            "tiny: wrote frame 3 to tiny.png\n");
}

TEST_F(SceneCommandsTest, StillByDefaultReplacesNoInput) {
  run({"still", "tiny.toml"});
  const std::string before = read("tiny.png");
  const ChildResult result = run({"still", "tiny.toml", "--set", "book.front=tiny.png"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(
      result.error,
      "rotatebook: tiny.png is a texture of the scene tiny and would be replaced; name another "
      "file with -o\n");
  EXPECT_EQ(read("tiny.png"), before);
}

// An option of its own says more than one of many keys.
TEST_F(SceneCommandsTest, SizeWinsOverTheKeyThatItIsShortFor) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--size", "96x54", "--set", "clip.size=[32, 18]"},
        {"--set", "clip.size=[32, 18]", "--size", "96x54"}}) {
    std::vector<std::string> words{"check", "--print", "tiny.toml"};
    words.insert(words.end(), options.begin(), options.end());
    const ChildResult result = runWithoutGraphics(words);
    EXPECT_EQ(result.status, 0) << result.error;
    EXPECT_THAT(result.output, HasSubstr("\nsize = [96, 54]"));
    EXPECT_THAT(result.output, Not(HasSubstr("[32, 18]")));
  }
}

TEST_F(SceneCommandsTest, CheckSaysOkAndWritesNothing) {
  write("b.toml", kTiny);
  const ChildResult result = runWithoutGraphics({"check", "tiny.toml", "b.toml"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output, "tiny.toml: ok\nb.toml: ok\n");
  EXPECT_THAT(result.error, IsEmpty());
  EXPECT_THAT(files(), ElementsAre("b.toml"));
}

TEST_F(SceneCommandsTest, CheckGoesOnAfterAWrongScene) {
  write("wrong.toml", "titel = 'T'\n" + std::string(kTiny).substr(15));
  const ChildResult result = run({"check", "wrong.toml", "tiny.toml"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "tiny.toml: ok\n");
  EXPECT_EQ(result.error,
            "rotatebook: wrong.toml:1:1: unknown key \"titel\"; did you mean \"title\"?\n");
}

TEST_F(SceneCommandsTest, CheckLooksAtTheTexturesToo) {
  write("covers/cut.png", "\x89PNG\r\n\x1a\n");
  const ChildResult cut = run({"check", "tiny.toml", "--set", "book.front=covers/cut.png"});
  EXPECT_EQ(cut.status, 2);
  EXPECT_EQ(cut.error,
            "rotatebook: --set book.front=covers/cut.png: can't read covers/cut.png: corrupt PNG: "
            "the file ends too early\n");
  const ChildResult missing = run({"check", "tiny.toml", "--set", "book.spine=no.png"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(missing.error,
            "rotatebook: --set book.spine=no.png: can't read no.png: No such file or directory\n");
}

TEST_F(SceneCommandsTest, CheckLooksAtTheWordsToo) {
  write("font.toml", std::string(kTiny) + "[overlay]\nshow = ['caption']\nfont = 'No Such Font'\n");
  const ChildResult font = run({"check", "font.toml"});
  EXPECT_EQ(font.status, 2);
  EXPECT_THAT(font.error,
              ::testing::MatchesRegex(
                  "rotatebook: font.toml:[0-9]+:8: no font family \"No Such Font\" .*\n"));
}

TEST_F(SceneCommandsTest, PrintedSceneRendersTheSame) {
  const ChildResult printed = run({"check", "--print", "tiny.toml", "--set", "body.mass=2"});
  EXPECT_EQ(printed.status, 0);
  EXPECT_THAT(printed.output, HasSubstr("\nmass = 2.0"));
  EXPECT_THAT(printed.output, HasSubstr("\nsubsteps = "));
  write("full/tiny.toml", printed.output);
  EXPECT_EQ(run({"check", "full/tiny.toml"}).output, "full/tiny.toml: ok\n");
  EXPECT_EQ(run({"check", "--print", "full/tiny.toml"}).output, printed.output);
  run({"render", "tiny.toml", "--set", "body.mass=2", "-o", "a"});
  run({"render", "full/tiny.toml", "-o", "b"});
  EXPECT_EQ(read("a/tiny.mp4"), read("b/tiny.mp4"));
  EXPECT_EQ(read("a/tiny.csv"), read("b/tiny.csv"));
  EXPECT_EQ(read("a/tiny/frame_00011.png"), read("b/tiny/frame_00011.png"));
}

TEST_F(SceneCommandsTest, CheckOfAFolderListsScenesWithLengthAndTitle) {
  write("more/longer-name.toml", kTiny);
  write("more/note.txt", "no scene");
  const ChildResult result = runWithoutGraphics({"check", "."});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output,
            "./more/longer-name.toml   0.2 s  Tiny\n"
            "./tiny.toml               0.2 s  Tiny\n");
}

TEST_F(SceneCommandsTest, CheckOfAFolderShowsWrongScenesAndGoesOn) {
  write("a.toml", "titel = 'T'\n");
  const ChildResult result = run({"check", "."});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "./tiny.toml   0.2 s  Tiny\n");
  EXPECT_EQ(result.error,
            "rotatebook: ./a.toml:1:1: unknown key \"titel\"; did you mean \"title\"?\n");
}

TEST_F(SceneCommandsTest, CheckOfAFolderNamesWhatItCannotReadAndGoesOn) {
  write("a/closed/b.toml", kTiny);
  write("a/hidden.toml", kTiny);
  fs::permissions(folder() / "a/closed", fs::perms::none);
  fs::permissions(folder() / "a/hidden.toml", fs::perms::none);
  ChildSettings settings;
  settings.obeysPermissions = true;
  const ChildResult result = run({"check", "."}, settings);
  fs::permissions(folder() / "a/closed", fs::perms::owner_all);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "./tiny.toml       0.2 s  Tiny\n");
  EXPECT_EQ(result.error,
            "rotatebook: can't list ./a/closed: Permission denied\n"
            "rotatebook: ./a/hidden.toml: can't be read: Permission denied\n");
}

TEST_F(SceneCommandsTest, CheckOfAFolderListsAFileOnceThatIsNamedToo) {
  EXPECT_EQ(run({"check", "tiny.toml", ".", "./tiny.toml"}).output, "tiny.toml   0.2 s  Tiny\n");
}

TEST_F(SceneCommandsTest, CheckFollowsLinksBeforeItGoesUp) {
  fs::create_directories(folder() / "a/b");
  fs::create_directory_symlink("a/b", folder() / "linked");
  EXPECT_EQ(run({"check", "tiny.toml", "linked/../tiny.toml"}).error,
            "rotatebook: linked/../tiny.toml: scene not found\n");
}

TEST_F(SceneCommandsTest, CheckOfAFolderNamesLinksToNothing) {
  fs::create_symlink("nowhere", folder() / "far-away.toml");
  const ChildResult result = run({"check", "."});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "./tiny.toml       0.2 s  Tiny\n");
  EXPECT_EQ(result.error, "rotatebook: ./far-away.toml: scene not found\n");
}

TEST_F(SceneCommandsTest, CheckOfAFolderLeavesOutWhatRendersLeave) {
  run({"render", "tiny.toml"});
  for (const char* name :
       {"out/x.partial/scene.toml", "out/x.replaced/scene.toml", "out/mine/scene.toml"}) {
    write(name, kTiny);
  }
  ASSERT_TRUE(has("out/tiny/scene.toml"));
  EXPECT_EQ(run({"check", "."}).output,
            "./out/mine/scene.toml   0.2 s  Tiny\n"
            "./tiny.toml             0.2 s  Tiny\n");
  fs::create_directory_symlink(folder(), folder() / "out/mine/back");
  EXPECT_EQ(run({"check", "out"}).output, "out/mine/scene.toml   0.2 s  Tiny\n");
}

}  // namespace
}  // namespace rotatebook::cli::testing
