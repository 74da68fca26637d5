// `rotatebook page`: what it draws and what it refuses; tests/page has what is on the page.
#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/program_test.h"
#include "image/png_file.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class PageCommand : public ProgramTest {
 protected:
  PageCommand() { run({"render", "tiny.toml", "--no-png", "--size", "640x360"}); }

  /// Of tiny.toml and `others`, at the size of the render.
  ChildResult page(std::vector<std::string> others = {}) const {
    others.insert(others.begin(), {"page", "tiny.toml", "--size", "640x360"});
    return run(others);
  }
};

constexpr const char* kThumbnail = "out/tiny.thumbnail.png";

/// Override that covers the clip with words.
const std::string kWordy = "overlay.show=['caption', 'clock', 'half_turns', 'energy']";

TEST_F(PageCommand, DrawsThumbnailsWithoutWords) {
  const ChildResult result = page();
  ASSERT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.output, "wrote out/index.html, 1 figure\n");
  const image::Image plain = image::readPng(folder() / kThumbnail);
  EXPECT_EQ(plain.width(), 480);
  EXPECT_EQ(plain.height(), 270);
  run({"render", "tiny.toml", "--no-png", "--size", "640x360", "--set", kWordy});
  ASSERT_EQ(page({"--set", kWordy}).status, 0);
  EXPECT_EQ(image::readPng(folder() / kThumbnail), plain);
  write("other.toml", kTiny);
  run({"render", "other.toml", "--size", "640x360", "--set", kWordy});
  ASSERT_EQ(page({"other.toml", "--set", kWordy}).status, 0);
  EXPECT_THAT(read("out/index.html"), AllOf(HasSubstr("src=\"tiny.thumbnail.png\""),
                                            HasSubstr("src=\"other.thumbnail.png\"")));
}

TEST_F(PageCommand, NeedsNoGraphicsWithoutThumbnails) {
  const std::vector<std::string> words{"page", "tiny.toml", "--size", "640x360"};
  const ChildResult refused = runWithoutGraphics(words);
  EXPECT_EQ(refused.status, 3);
  EXPECT_THAT(refused.error, AllOf(HasSubstr("can't draw"), HasSubstr("--no-thumbnails")));
  EXPECT_FALSE(has("out/index.html"));
  std::vector<std::string> without = words;
  without.emplace_back("--no-thumbnails");
  const ChildResult result = runWithoutGraphics(without);
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_TRUE(has("out/index.html"));
  EXPECT_FALSE(has(kThumbnail));
}

TEST_F(PageCommand, ShowsASceneOnceHoweverOftenItIsNamed) {
  const ChildResult result =
      page({"./tiny.toml", "../" + folder().filename().string() + "/tiny.toml"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.output, "wrote out/index.html, 1 figure\n");
  write("in/tiny.toml", kTiny);
  EXPECT_THAT(page({"in/tiny.toml"}).error, HasSubstr("two scenes are named tiny"));
}

TEST_F(PageCommand, LeavesOutAGifOfOtherSettings) {
  const std::vector<std::string> gif{"render",  "tiny.toml", "--no-png", "--size",
                                     "640x360", "--format",  "gif"};
  std::vector<std::string> other = gif;
  other.insert(other.end(), {"--set", "camera.field_of_view_deg=60"});
  run(other);
  run({"render", "tiny.toml", "--no-png", "--size", "640x360"});
  EXPECT_THAT(page().error, HasSubstr("note: out/tiny.gif isn't linked: it was made from another "
                                      "scene or with other settings\n"));
  run(gif);
  EXPECT_EQ(page().output, "wrote out/index.html, 1 figure\n");
}

TEST_F(PageCommand, ReplacesNothingOfOthers) {
  ASSERT_EQ(page().status, 0);
  EXPECT_EQ(page().status, 0) << "its own";
  const std::vector<std::pair<std::string, std::string>> reasons{
      {"out/index.html", " is no page of rotatebook, and would be replaced"},
      {kThumbnail, " has no mark of rotatebook, and the page's picture of tiny would replace it"}};
  for (const auto& [name, reason] : reasons) {
    const std::string own = read(name);
    write(name, "<html>mine</html>");
    const ChildResult refused = page();
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.error, HasSubstr(name + reason));
    EXPECT_EQ(read(name), "<html>mine</html>");
    write(name, own);
  }
}

TEST_F(PageCommand, RefusesTheResultOfOtherSettings) {
  run({"render", "tiny.toml", "--no-png", "--size", "640x360", "--no-mp4", "--set",
       "camera.field_of_view_deg=60"});
  const ChildResult result = page();
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(
      result.error,
      HasSubstr("out/tiny.json was made from another scene or with other settings; render it "
                "again"));
}

TEST_F(PageCommand, RefusesPicturesOfAnotherSize) {
  const ChildResult result = run({"page", "tiny.toml"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.error,
            "rotatebook: out/tiny.mp4: its pictures are 640x360, and the scene's are 64x36; render "
            "it again (or give this command the same --size and --set): rotatebook render "
            "tiny.toml -o out\n");
  EXPECT_FALSE(has("out/index.html"));
}

TEST_F(PageCommand, SaysWhichVideosAreNotTheScenes) {
  run({"render", "tiny.toml", "--no-png", "-o", "small", "--format", "gif"});
  fs::copy_file(folder() / "small/tiny.gif", folder() / "out/tiny.gif");
  const ChildResult result = page();
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.error,
            "note: out/tiny.gif isn't linked: its pictures are 64x36, and the scene's are "
            "640x360\n");
  EXPECT_EQ(result.output, "wrote out/index.html, 1 figure\n");
  EXPECT_THAT(read("out/index.html"), Not(HasSubstr("tiny.gif")));
}

TEST_F(PageCommand, KeepsTexturesOfTheNamesOfThumbnails) {
  ASSERT_EQ(run({"still", "tiny.toml", "--time", "0", "-o", kThumbnail}).status, 0);
  const std::string before = read(kThumbnail);
  write("covered.toml", "book.back = \"out/tiny.thumbnail.png\"\n" + std::string(kTiny));
  run({"render", "covered.toml", "--no-png", "--size", "640x360"});
  const ChildResult result = page({"covered.toml"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.error,
              HasSubstr("out/tiny.thumbnail.png is a texture of the scene covered and "
                        "would be replaced; name another folder with -o"));
  EXPECT_THAT(result.output, IsEmpty());
  EXPECT_TRUE(read(kThumbnail) == before);
}

}  // namespace
}  // namespace rotatebook::cli::testing
