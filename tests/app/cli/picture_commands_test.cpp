// `rotatebook assemble`, `sheet` and `diff`.
#include <algorithm>
#include <string>

#include "cli/program_test.h"
#include "image/png_file.h"
#include "video/decoded_video.h"

namespace rotatebook::cli::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class AssembleCommand : public ProgramTest {
 protected:
  AssembleCommand() { run({"render", "tiny.toml"}); }
};

TEST_F(AssembleCommand, MakesTheFileOfTheRender) {
  const ChildResult result = runWithoutGraphics({"assemble", "out/tiny", "-o", "x.mp4"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.output, "wrote 12 frames to x.mp4\n");
  EXPECT_EQ(read("x.mp4"), read("out/tiny.mp4"));
}

TEST_F(AssembleCommand, SaysWhichFramesItTookOfAClipThatIsNotWhole) {
  ASSERT_EQ(run({"render", "tiny.toml", "--frames", "2:6", "-o", "part"}).status, 0);
  const ChildResult result = runWithoutGraphics({"assemble", "part/tiny", "-o", "x.mp4"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.output, "wrote 4 frames to x.mp4: 2:6 of the scene's 12\n");
}

TEST_F(AssembleCommand, TakesFramesFromElsewhereAtARate) {
  std::filesystem::remove(folder() / "out/tiny/scene.toml");
  EXPECT_EQ(run({"assemble", "out/tiny", "-o", "x.mp4", "--fps", "30000/1001"}).status, 0);
  const auto clip = video::testing::decodeVideo(folder() / "x.mp4");
  EXPECT_EQ(clip.frames.size(), 12U);
  EXPECT_NEAR(static_cast<double>(clip.duration) / static_cast<double>(clip.timeScale),
              12 * 1001 / 30000.0, 1e-6);
}

TEST_F(AssembleCommand, RefusesASwappedFrame) {
  write("out/tiny/frame_00003.png", read("out/tiny/frame_00004.png"));
  const ChildResult result = run({"assemble", "out/tiny", "-o", "x.mp4"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.error, ::testing::StartsWith("rotatebook: out/tiny/frame_00003.png isn't the "
                                                  "picture that was drawn: "));
  EXPECT_FALSE(has("x.mp4"));
  ASSERT_EQ(run({"render", "tiny.toml", "--resume"}).status, 0);
  EXPECT_EQ(run({"assemble", "out/tiny", "-o", "x.mp4"}).status, 0);
}

using SheetCommand = ProgramTest;

TEST_F(SheetCommand, WritesAPictureOfTheSizeItReports) {
  const ChildResult result =
      run({"still", "tiny.toml", "-o", "x.png", "--count", "3", "--columns", "2"});
  EXPECT_EQ(result.status, 0) << result.error;
  const image::Image sheet = image::readPng(folder() / "x.png");
  EXPECT_EQ(result.output, "wrote x.png, " + std::to_string(sheet.width()) + "x" +
                               std::to_string(sheet.height()) + "\n");
  EXPECT_GT(sheet.width(), sheet.height());
}

TEST_F(SheetCommand, NamesThePictureAfterTheScene) {
  const ChildResult one = run({"still", "tiny.toml", "--count", "1"});
  EXPECT_EQ(one.status, 0) << one.error;
  write("b.toml", kTiny);
  EXPECT_EQ(run({"still", "tiny.toml", "b.toml", "--count", "1"}).status, 0);
  EXPECT_THAT(files(), ElementsAre("b.toml", "sheet.png", "tiny.sheet.png"));
  EXPECT_THAT(run({"still", "tiny.toml", "--count", "1"}).error,
              HasSubstr("note: replaced tiny.sheet.png\n"));
}

TEST_F(SheetCommand, RefusesMorePixelsThanFitIntoMemory) {
  const ChildResult result =
      run({"still", "tiny.toml", "-o", "x.png", "--count", "300", "--size", "1280x720"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.error, HasSubstr("; take fewer or smaller pictures, for example --size "));
  EXPECT_FALSE(has("x.png"));
}

TEST_F(SheetCommand, ReadsASceneFromAPipeAndWritesThePictureIntoOne) {
  const auto shell = [this](const std::string& line) {
    return WEXITSTATUS(std::system(("cd '" + folder().string() + "' && " + line).c_str()));
  };
  const std::string program = "'" ROTATEBOOK_PROGRAM "' ";
  EXPECT_EQ(run({"still", "tiny.toml", "-o", "file.png"}).status, 0);
  EXPECT_EQ(shell(program + "still - -o - < tiny.toml 2> said.txt > pipe.png"), 0);
  EXPECT_EQ(read("pipe.png"), read("file.png"));
  EXPECT_THAT(read("said.txt"), StartsWith("stdin: wrote frame "));
  EXPECT_EQ(shell(program + "simulate - --csv - < tiny.toml 2> said.txt > pipe.csv"), 0);
  EXPECT_EQ(run({"simulate", "tiny.toml", "--csv", "file.csv"}).status, 0);
  EXPECT_EQ(read("pipe.csv"), read("file.csv"));
  EXPECT_EQ(shell(program + "render - --no-png < tiny.toml > said.txt"), 0);
  EXPECT_TRUE(has("out/stdin.mp4"));
  EXPECT_EQ(shell("echo 'a = 1' | " + program + "check - 2> said.txt"), 2);
  EXPECT_THAT(read("said.txt"), StartsWith("rotatebook: stdin:1:1: "));
  EXPECT_EQ(shell(program + "check - - < tiny.toml > said.txt 2>&1"), 2);
  EXPECT_THAT(read("said.txt"),
              HasSubstr("stdin: can't be read: it is empty, or was read already"));
  EXPECT_EQ(shell(program + "submit render - --plan list < tiny.toml 2> said.txt"), 2);
}

class DiffCommand : public ProgramTest {
 protected:
  // A grey picture, and the same with one of its 200 pixels lighter by 10.
  DiffCommand() {
    image::Image picture(20, 10, image::PixelFormat::Rgb8);
    for (int y = 0; y < 10; ++y) std::fill_n(picture.row(y), 60, std::uint8_t{100});
    writePng(folder() / "a.png", picture.view());
    picture.row(4)[3 * 7 + 1] = 110;
    writePng(folder() / "b.png", picture.view());
  }
};

constexpr const char* kDifferent =
    "different: largest difference 10 of 255, mean 0.0167, 1 pixels (0.5000 %) over the bound\n";

TEST_F(DiffCommand, IsZeroForEqualPictures) {
  const ChildResult result = run({"diff", "a.png", "a.png"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output,
            "same: largest difference 0 of 255, mean 0.0000, 0 pixels (0.0000 %) over the bound\n");
}

TEST_F(DiffCommand, IsOneForDifferentPictures) {
  const ChildResult result = run({"diff", "a.png", "b.png"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.output, kDifferent);
  EXPECT_THAT(result.error, IsEmpty());
  EXPECT_THAT(files(), ElementsAre("a.png", "b.png"));
}

TEST_F(DiffCommand, TakesTheLargestDifference) {
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--max", "9"}).status, 1);
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--max", "10"}).status, 0);
}

TEST_F(DiffCommand, TakesTheShareOfPixels) {
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--fail-percent", "0.49"}).status, 1);
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--fail-percent", "0.5"}).status, 0);
}

TEST_F(DiffCommand, DrawsTheDifferenceEnlarged) {
  EXPECT_EQ(run({"diff", "a.png", "b.png", "-o", "d.png"}).status, 1);
  image::Image expected(20, 10, image::PixelFormat::Rgb8);
  expected.row(4)[3 * 7 + 1] = 160;
  EXPECT_EQ(image::readPng(folder() / "d.png"), expected);
}

TEST_F(DiffCommand, IsTwoWhereNothingCanBeCompared) {
  const image::Image small(4, 4, image::PixelFormat::Rgb8);
  writePng(folder() / "small.png", small.view());
  const ChildResult sizes = run({"diff", "a.png", "small.png", "-o", "d.png"});
  EXPECT_EQ(sizes.status, 2);
  EXPECT_EQ(sizes.error, "rotatebook: can't compare pictures of different sizes: 20x10 and 4x4\n");
  const ChildResult missing = run({"diff", "a.png", "no.png", "-o", "d.png"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(missing.error, "rotatebook: can't read no.png: No such file or directory\n");
  EXPECT_FALSE(has("d.png"));
}

}  // namespace
}  // namespace rotatebook::cli::testing
