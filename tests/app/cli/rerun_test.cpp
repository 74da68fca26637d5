// `rotatebook verify --again`.
#include <filesystem>
#include <string>
#include <vector>

#include "base/same_bytes.h"
#include "cli/program_test.h"
#include "image/png_file.h"
#include "messages.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using rotatebook::testing::sameBytes;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class RerunCommand : public ProgramTest {
 protected:
  void render(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"render", "tiny.toml", "--no-png"};
    words.insert(words.end(), more.begin(), more.end());
    const ChildResult result = run(words);
    ASSERT_EQ(result.status, 0) << result.error;
  }

  std::vector<std::string> filesBelow(const std::string& name) const {
    std::vector<std::string> names;
    for (const std::string& file : files()) {
      if (file.starts_with(name) && file != name) names.push_back(file);
    }
    return names;
  }
};

TEST_F(RerunCommand, HasTheWordsOfAFileThatIsGone) {
  write("french.words", "decimal_mark = \",\"\n");
  render({"--set", "overlay.words=french.words", "--set", "overlay.show=['clock']"});
  fs::remove(folder() / "french.words");
  EXPECT_EQ(run({"verify", "out/tiny.mp4"}).status, 0);
  const ChildResult result = run({"verify", "out/tiny.mp4", "--again", "again"});
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_TRUE(sameBytes(read("again/tiny.mp4"), read("out/tiny.mp4")));
}

TEST_F(RerunCommand, MakesTheSameFile) {
  render({"--set", "video.crf=25", "--set", "initial.angular_velocity=[4, 1, 0]"});
  fs::rename(folder() / "out/tiny.mp4", folder() / "renamed.mp4");
  fs::remove(folder() / "tiny.toml");
  const ChildResult result = run({"verify", "renamed.mp4", "--again", "again"});
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(result.output,
              HasSubstr("\n  again/tiny.mp4 has exactly the bytes of renamed.mp4\n"));
  EXPECT_TRUE(sameBytes(read("again/tiny.mp4"), read("renamed.mp4")));
  EXPECT_THAT(filesBelow("again/"), Not(::testing::Contains(HasSubstr("frame_"))));
}

TEST_F(RerunCommand, MakesPartsInTheirFormatWithFramesIfAsked) {
  render({"--frames", "3:5", "--format", "webm"});
  const ChildResult result =
      run({"verify", "out/tiny_00003-00005.webm", "--again", "again", "--png"});
  EXPECT_EQ(result.status, 0) << result.output << result.error;
  EXPECT_THAT(filesBelow("again/"),
              ElementsAre("again/tiny.csv", "again/tiny.json", "again/tiny/",
                          "again/tiny/frame_00003.png", "again/tiny/frame_00004.png",
                          "again/tiny/frames.manifest", "again/tiny/frames.xxh128",
                          "again/tiny/scene.toml", "again/tiny_00003-00005.webm"));
  EXPECT_TRUE(sameBytes(read("again/tiny_00003-00005.webm"), read("out/tiny_00003-00005.webm")));
}

TEST_F(RerunCommand, NeverOverwritesTheClip) {
  render({});
  const std::string clip = read("out/tiny.mp4");
  fs::create_symlink("out", folder() / "link");
  fs::create_directories(folder() / "hard");
  fs::create_hard_link(folder() / "out/tiny.mp4", folder() / "hard/tiny.mp4");
  for (const char* output : {"out", "./out/", "link", "hard"}) {
    const ChildResult result = run({"verify", "out/tiny.mp4", "--again", output});
    EXPECT_EQ(result.status, 2) << output;
    EXPECT_MESSAGE(result.error);
    EXPECT_THAT(result.output, IsEmpty());
  }
  EXPECT_TRUE(sameBytes(read("out/tiny.mp4"), clip));
}

TEST_F(RerunCommand, ReplacesAnotherScenesClipOnlyIfAsked) {
  render({"--set", "initial.angular_velocity=[4, 1, 0]"});
  ASSERT_EQ(run({"render", "tiny.toml", "-o", "other"}).status, 0);
  fs::create_directories(folder() / "kept");
  fs::copy(folder() / "other", folder() / "kept", fs::copy_options::recursive);
  const auto expectRefused = [&](const std::string& file) {
    const ChildResult result = run({"verify", "out/tiny.mp4", "--again", "other", "--png"});
    EXPECT_EQ(result.status, 2) << result.output;
    EXPECT_EQ(result.error,
              "rotatebook: " + file +
                  " isn't from the clip's scene and would be lost; name another folder "
                  "with -o, or replace it with --overwrite\n");
  };
  expectRefused("other/tiny.mp4");
  expectSameFiles("other", "kept");
  fs::remove(folder() / "other/tiny.mp4");
  expectRefused("other/tiny/scene.toml");  // Its frames are as dear.
  write("other/tiny.mp4", "notes");
  expectRefused("other/tiny.mp4");
  const ChildResult replaced = run({"verify", "out/tiny.mp4", "--again", "other", "--overwrite"});
  EXPECT_EQ(replaced.status, 0) << replaced.output << replaced.error;
  EXPECT_TRUE(sameBytes(read("other/tiny.mp4"), read("out/tiny.mp4")));
  EXPECT_EQ(run({"verify", "out/tiny.mp4", "--again", "other"}).status, 0);  // Its own.
}

TEST_F(RerunCommand, TakesTexturesFromOutsideOnlyIfAllowed) {
  const image::Image cover(8, 12, image::PixelFormat::Rgb8);
  fs::create_directories(folder() / "scenes");
  writePng(folder() / "cover.png", cover.view());
  fs::copy_file(folder() / "tiny.toml", folder() / "scenes/tiny.toml");
  ASSERT_EQ(run({"render", "scenes/tiny.toml", "--no-png", "--set", "book.front=../cover.png",
                 "--allow-outside"})
                .status,
            0);
  const std::vector<std::string> words{"verify", "out/tiny.mp4",   "--again",
                                       "again",  "--scene-folder", "scenes"};
  EXPECT_EQ(run(words).status, 2);
  std::vector<std::string> allowing = words;
  allowing.push_back("--allow-outside");
  const ChildResult allowed = run(allowing);
  EXPECT_EQ(allowed.status, 0) << allowed.output << allowed.error;
}

TEST_F(RerunCommand, ReportsWhatDiffers) {
  render({});
  std::string clip = read("out/tiny.mp4");
  const std::string whole = clip;
  const std::string renderer = "# Renderer: ";
  write("other.mp4", clip.replace(clip.find(renderer), renderer.size(), "# Sendererx "));
  ChildResult result = run({"verify", "other.mp4", "--again", "again"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output, AllOf(HasSubstr("\n  again/tiny.mp4 has OTHER bytes than other.mp4\n"),
                                   HasSubstr("\n    the renderer was not recorded, here it is ")));
  clip = whole;
  clip.back() ^= 1;
  write("other.mp4", clip);
  result = run({"verify", "other.mp4", "--again", "again"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.output,
              HasSubstr("\n    version, renderer, FFmpeg and motion are those recorded: "));
}

TEST_F(RerunCommand, ReportsThatAClipWasCutOff) {
  render({});
  const std::string clip = read("out/tiny.mp4");
  write("cut.mp4", clip.substr(0, clip.size() - 100));
  const ChildResult result = run({"verify", "cut.mp4", "--again", "again"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(
      result.output,
      EndsWith("\n  again/tiny.mp4 has OTHER bytes than cut.mp4\n    cut.mp4 ends early, or "
               "is damaged: it has " +
               std::to_string(clip.size() - 100) + " of at least " + std::to_string(clip.size()) +
               " bytes; copy it again, or render it again\n"));
  EXPECT_TRUE(sameBytes(read("again/tiny.mp4"), clip));
}

TEST_F(RerunCommand, RefusesWhatHoldsNoRecord) {
  render({"--format", "gif"});
  const ChildResult result = run({"verify", "out/tiny.gif", "--again", "again"});
  EXPECT_EQ(result.status, 2);
  EXPECT_MESSAGE(result.error);
  EXPECT_FALSE(has("again"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
