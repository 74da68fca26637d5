#include "pipeline/assemble.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/png_file.h"
#include "messages.h"
#include "pipeline/small_clip.h"
#include "system/atomic_file.h"
#include "video/decoded_video.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::bytesOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::kFrames;
using ::testing::Not;
using testing::pngAndMp4;

// Frames of one colour, from elsewhere.
void writeFrames(const fs::path& folder, const std::vector<std::int64_t>& indices, int width = 32,
                 int height = 16) {
  fs::create_directories(folder);
  for (const std::int64_t index : indices) {
    image::writePng(folder / store::frameName(index),
                    image::Image(width, height, image::PixelFormat::Rgb8).view());
  }
}

class Assemble : public ::testing::Test {
 protected:
  std::int64_t assembled(std::optional<FrameRate> rate = {}) const {
    return assemble(frames_, mp4_, rate, {}).frames.count();
  }

  std::string inputError(std::optional<FrameRate> rate = {}) const {
    const std::string message = testing::messageOf<InputError>([&] { assembled(rate); });
    EXPECT_FALSE(fs::exists(mp4_)) << "a file is left after: " << message;
    return message;
  }

  const fs::path folder_ = testing::emptyFolder();
  const fs::path frames_ = folder_ / "small";
  const fs::path mp4_ = folder_ / "assembled.mp4";
};

TEST_F(Assemble, MakesTheSameFileAsTheRender) {
  testing::render(testing::smallScene(), pngAndMp4(folder_));
  EXPECT_EQ(assembled(), kFrames);
  EXPECT_EQ(bytesOf(mp4_), bytesOf(folder_ / "small.mp4"));
}

TEST_F(Assemble, MakesItOfFramesAlone) {
  const fs::path whole = folder_ / "whole";
  testing::render(testing::smallScene(), pngAndMp4(whole));
  testing::render(testing::smallScene(), {.folder = folder_, .outputs = {pngOutput()}});
  EXPECT_THAT(bytesOf(frames_ / "scene.toml"), Not(HasSubstr("FFmpeg")));
  EXPECT_EQ(assembled(), kFrames);
  EXPECT_EQ(bytesOf(mp4_), bytesOf(whole / "small.mp4"));
}

TEST_F(Assemble, RefusesAFrameThatIsntAsItWasDrawn) {
  testing::render(testing::smallScene(), {.folder = folder_, .outputs = {pngOutput()}});
  for (const std::int64_t changed : {0, 5}) {
    const fs::path frame = frames_ / store::frameName(changed);
    const std::string drawn = bytesOf(frame);
    fs::copy_file(frames_ / store::frameName(changed + 1), frame,
                  fs::copy_options::overwrite_existing);
    EXPECT_EQ(inputError(), frame.string() + " isn't the picture that was drawn: " +
                                (frames_ / "frames.xxh128").string() +
                                " has another checksum for it; render the scene with --resume, "
                                "which draws it again, or remove " +
                                (frames_ / "frames.xxh128").string() +
                                " to join frames that were changed on purpose");
    std::ofstream(frame, std::ios::binary) << drawn;
  }
  EXPECT_EQ(assembled(), kFrames);
}

TEST_F(Assemble, RefusesFramesThatWentMissingAtEitherEnd) {
  testing::render(testing::smallScene(), {.folder = folder_, .outputs = {pngOutput()}});
  for (const std::int64_t missing : {std::int64_t{0}, kFrames - 1}) {
    const fs::path frame = frames_ / store::frameName(missing);
    fs::rename(frame, folder_ / "kept.png");
    EXPECT_EQ(inputError(), frames_.string() + ": " + store::frameName(missing) +
                                " is missing, although frames.xxh128 lists it; render the scene "
                                "with --resume, which draws it again, or remove " +
                                (frames_ / "frames.xxh128").string() +
                                " to join the frames that are there");
    fs::rename(folder_ / "kept.png", frame);
  }
  fs::remove(frames_ / store::frameName(0));
  fs::remove(frames_ / "frames.xxh128");
  EXPECT_EQ(assembled(), kFrames - 1);
}

// Of events that aren't here, a video needs those of its chapters alone.
TEST_F(Assemble, NeedsARecordingForChaptersAlone) {
  writeFrames(frames_, {0, 1, 2});
  const auto write = [&](const std::string& more) {
    std::ofstream(frames_ / "scene.toml")
        << "[simulation]\nmodel = 'recorded'\nfile = 'gone.csv'\n[clip]\nfps = 30\n"
           "duration = 0.1\nsize = [32, 16]\n[[cue]]\nat = 'flip 1'\ntext = 'Now'\n"
        << more;
  };
  write("chapter = 'Over'\n");
  EXPECT_MESSAGE(inputError());
  write("");
  EXPECT_EQ(assembled(), 3);
}

TEST_F(Assemble, SaysWhyAFrameCannotBeRead) {
  testing::render(testing::smallScene(), {.folder = folder_, .outputs = {pngOutput()}});
  const fs::path frame = frames_ / store::frameName(5);
  fs::remove(frame);
  fs::create_symlink("nowhere", frame);
  EXPECT_EQ(testing::messageOf<MachineError>([&] { assembled(); }),
            "can't read " + frame.string() + ": No such file or directory");
  EXPECT_FALSE(fs::exists(mp4_));
}

TEST_F(Assemble, TakesNoFramesThatARenderStillMakes) {
  testing::render(testing::smallScene(), {.folder = folder_, .outputs = {pngOutput()}});
  const fs::path whole = fs::canonical(frames_);
  const fs::path partial = folder_ / "small.partial";
  fs::copy(frames_, partial, fs::copy_options::recursive);
  for (const fs::path& folder : {frames_, frames_ / "", partial}) {
    const system::AdvisoryLock lock(frames_, system::Lock::Exclusive);
    EXPECT_EQ(testing::messageOf<MachineError>([&] { assemble(folder, mp4_, {}, {}); }),
              "another process is writing " + whole.string() + "; wait for it to end");
    EXPECT_FALSE(fs::exists(mp4_));
  }
  const system::AdvisoryLock other(frames_, system::Lock::Shared);
  EXPECT_EQ(assembled(), kFrames);
}

TEST_F(Assemble, TakesTheWholeAloneIfAsked) {
  const auto whole = [&] { assemble(frames_, mp4_, {}, {}, true); };
  const RenderOptions part{
      .folder = folder_, .outputs = {pngOutput()}, .frames = store::FrameRange{0, 9}};
  testing::render(testing::smallScene(), part);
  EXPECT_EQ(testing::messageOf<InputError>(whole),
            frames_.string() +
                " holds the frames 0:9 of the scene's 12; render the scene with --resume, which "
                "draws the others, or leave out --whole");
  EXPECT_FALSE(fs::exists(mp4_));
  testing::render(
      testing::smallScene(),
      {.folder = folder_, .outputs = {pngOutput()}, .frames = store::FrameRange{9, kFrames}});
  EXPECT_NO_THROW(whole());
  EXPECT_TRUE(fs::exists(mp4_));
  writeFrames(folder_ / "bare", {0, 1});
  EXPECT_EQ(testing::messageOf<InputError>(
                [&] { assemble(folder_ / "bare", mp4_, FrameRate{}, {}, true); }),
            "--whole: " + (folder_ / "bare").string() +
                " has no scene.toml that says how many frames there are");
}

// Each chunk of a PNG has a checksum of its own, as have its pixels.
TEST_F(Assemble, TakesAFrameWithoutAChecksumOnlyIfItIsAWholePng) {
  testing::render(testing::smallScene(), {.folder = folder_, .outputs = {pngOutput()}});
  const fs::path sums = frames_ / "frames.xxh128", frame = frames_ / store::frameName(5);
  std::string lines = bytesOf(sums);
  std::ofstream(sums) << lines.erase(lines.find("frame_00005.png") - 34, 50);
  EXPECT_EQ(assemble(frames_, mp4_, {}, {}).unlisted, 1);
  fs::remove(mp4_);
  const std::string drawn = bytesOf(frame);
  for (std::size_t at = 40; at < drawn.size(); at += drawn.size() / 20) {
    std::string damaged = drawn;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    std::ofstream(frame, std::ios::binary) << damaged;
    EXPECT_THAT(inputError(), HasSubstr("corrupt PNG")) << at;
    std::ofstream(frame, std::ios::binary) << drawn.substr(0, at);
    EXPECT_THAT(inputError(), HasSubstr("corrupt PNG")) << at;
  }
}

TEST_F(Assemble, NeedsAnEndingThatNamesAFormat) {
  writeFrames(frames_, {0, 1});
  for (const char* name : {"clip.mkv", "clip", "clip.MP4"}) {
    const fs::path video = folder_ / name;
    EXPECT_MESSAGE(
        testing::messageOf<InputError>([&] { assemble(frames_, video, FrameRate{}, {}); }));
    EXPECT_FALSE(fs::exists(video));
  }
}

TEST_F(Assemble, TakesChangedFramesWithoutTheirChecksums) {
  testing::render(testing::smallScene(), {.folder = folder_, .outputs = {pngOutput()}});
  const fs::path frame = frames_ / store::frameName(5);
  fs::copy_file(frames_ / store::frameName(6), frame, fs::copy_options::overwrite_existing);
  const fs::path sums = frames_ / "frames.xxh128";
  std::string lines = bytesOf(sums);
  const std::size_t name = lines.find("frame_00005.png");
  ASSERT_NE(name, std::string::npos);
  std::ofstream(sums) << lines.erase(name - 34, 50);  // Its line.
  EXPECT_EQ(assembled(), kFrames);
  fs::remove(sums);
  EXPECT_EQ(assembled(), kFrames);
}

TEST_F(Assemble, KeepsTheScenesEncoding) {
  testing::render(
      testing::smallScene({"video.crf=35", "clip.fps=\"30000/1001\"", "video.preset=ultrafast"}),
      pngAndMp4(folder_));
  assembled();
  EXPECT_EQ(bytesOf(mp4_), bytesOf(folder_ / "small.mp4"));
}

TEST_F(Assemble, TakesFramesFromElsewhereAtAGivenRate) {
  writeFrames(frames_, {0, 1, 2});
  EXPECT_EQ(assembled(FrameRate{25, 1}), 3);
  const auto video = video::testing::decodeVideo(mp4_);
  EXPECT_EQ(video.frames.size(), 3U);
  EXPECT_EQ(video.containerDurationUs, 120000);
}

TEST_F(Assemble, TakesFramesThatStartLater) {
  writeFrames(frames_, {7, 8, 9, 10});
  EXPECT_EQ(assembled(FrameRate{25, 1}), 4);
}

TEST_F(Assemble, IgnoresForeignFiles) {
  writeFrames(frames_, {0, 1});
  std::ofstream(frames_ / "frame_0002.png") << "not a frame";
  std::ofstream(frames_ / "notes.txt") << "not a frame";
  EXPECT_EQ(assembled(FrameRate{25, 1}), 2);
}

TEST_F(Assemble, ReportsItsProgress) {
  writeFrames(frames_, {3, 4, 5});
  std::vector<std::int64_t> done;
  assemble(frames_, mp4_, FrameRate{25, 1}, [&](RenderProgress progress) {
    done.push_back(progress.done);
    EXPECT_EQ(progress.total, 3);
  });
  ASSERT_FALSE(done.empty());
  EXPECT_EQ(done.back(), 3);
}

TEST_F(Assemble, RefusesAMissingFolder) {
  EXPECT_MESSAGE(inputError());
}

TEST_F(Assemble, RefusesAFolderWithoutFrames) {
  fs::create_directories(frames_);
  EXPECT_EQ(inputError(), frames_.string() + " holds no frames named like frame_00000.png");
}

TEST_F(Assemble, NamesTheFirstFrameThatIsMissing) {
  writeFrames(frames_, {0, 1, 4, 6});
  EXPECT_EQ(inputError(FrameRate{25, 1}),
            frames_.string() + ": frame_00002.png is missing; frame_00004.png comes next");
}

TEST_F(Assemble, NamesBothFramesOfDifferentSizes) {
  writeFrames(frames_, {0, 1});
  writeFrames(frames_, {2}, 48, 16);
  EXPECT_EQ(inputError(FrameRate{25, 1}),
            "frames differ in size: " + (frames_ / store::frameName(0)).string() + " is 32x16, " +
                (frames_ / store::frameName(2)).string() + " is 48x16");
}

/// Writes a frame of half transparent red, or one of opaque red that has an alpha channel, too.
void writeRed(const fs::path& folder, std::int64_t index, int alpha) {
  image::Image picture(32, 16, image::PixelFormat::Rgba8);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      picture.row(y)[4 * x] = 255;
      picture.row(y)[4 * x + 3] = static_cast<std::uint8_t>(y == 9 && x == 9 ? alpha : 255);
    }
  }
  image::writePng(folder / store::frameName(index), picture.view(), true);
}

TEST_F(Assemble, LosesNoTransparency) {
  writeFrames(frames_, {0, 1});
  writeRed(frames_, 2, 254);
  const std::string third = (frames_ / store::frameName(2)).string();
  const std::string lost = third + " has transparent pixels, which ";
  EXPECT_EQ(inputError(FrameRate{25, 1}),
            lost +
                "mp4 can't hold; use the ending .webm, .apng or .mov, or lay the frames over a "
                "background");
  const std::vector<std::pair<std::string, std::string>> others{
      {"a.gif", "gif can't hold"},
      {"a.webm", "would be lost, as " + (frames_ / store::frameName(0)).string() +
                     " has no alpha channel; give all frames one"}};
  for (const auto& [name, reason] : others) {
    const fs::path video = folder_ / name;
    EXPECT_MESSAGE(
        testing::messageOf<InputError>([&] { assemble(frames_, video, FrameRate{}, {}); }));
    EXPECT_FALSE(fs::exists(video));
  }
  writeRed(frames_, 0, 255);
  EXPECT_NO_THROW(assemble(frames_, folder_ / "a.webm", FrameRate{}, {}));
  writeRed(frames_, 2, 255);
  EXPECT_EQ(assembled(FrameRate{25, 1}), 3);
}

/// Says that a frame's colours are those of BT.2020, with PQ as their curve.
void makeWide(const fs::path& frame) {
  const std::string code(
      "\0\0\0\x04"
      "cICP\x09\x10\0\x01"
      "\x4d\x23\x23\xfe",
      16);
  std::string bytes = bytesOf(frame);
  bytes.insert(33, code);  // after IHDR
  std::ofstream(frame, std::ios::binary) << bytes;
}

TEST_F(Assemble, SaysWhichColoursAreLost) {
  writeFrames(frames_, {0, 1, 2, 3});
  const auto lost = [&] { return assemble(frames_, mp4_, FrameRate{25, 1}, {}).lost; };
  EXPECT_TRUE(lost().empty());
  for (const int index : {0, 2, 3}) makeWide(frames_ / store::frameName(index));
  ASSERT_EQ(lost().size(), 1U);
  EXPECT_EQ(lost()[0].frames, 3);
  EXPECT_THAT(
      lost()[0].text,
      HasSubstr("colours of the code 9, 16, 0, 1 (cICP), in place of which sRGB is assumed"));
}

TEST_F(Assemble, NeedsARateForFramesFromElsewhere) {
  writeFrames(frames_, {0, 1});
  EXPECT_EQ(inputError(),
            frames_.string() + " has no scene.toml that sets the frame rate; give it with --fps");
}

TEST_F(Assemble, RefusesARateWhereTheSceneStatesIt) {
  testing::render(testing::smallScene(), {.folder = folder_, .outputs = {pngOutput()}});
  EXPECT_EQ(inputError(FrameRate{25, 1}),
            (frames_ / "scene.toml").string() + " sets the frame rate already; leave --fps out");
}

TEST_F(Assemble, NamesAFrameThatIsNoPng) {
  writeFrames(frames_, {0, 1});
  std::ofstream(frames_ / store::frameName(2)) << "not a PNG";
  EXPECT_MESSAGE(inputError(FrameRate{25, 1}));
}

TEST_F(Assemble, RefusesFramesOfAnOddSize) {
  writeFrames(frames_, {0, 1}, 33, 17);
  EXPECT_MESSAGE(inputError(FrameRate{25, 1}));
}

TEST_F(Assemble, KeepsAnOlderFileAndNothingElseWhenItFails) {
  writeFrames(frames_, {0, 1});
  writeFrames(frames_, {2}, 48, 16);
  std::ofstream(mp4_) << "older";
  EXPECT_THROW(assembled(FrameRate{25, 1}), InputError);
  EXPECT_EQ(bytesOf(mp4_), "older");
  EXPECT_THAT(testing::namesIn(folder_), ElementsAre("assembled.mp4", "small"));
}

TEST_F(Assemble, SaysWhereItCannotWrite) {
  writeFrames(frames_, {0, 1});
  const fs::path mp4 = folder_ / "missing" / "a.mp4";
  EXPECT_MESSAGE(
      testing::messageOf<MachineError>([&] { assemble(frames_, mp4, FrameRate{}, {}); }));
}

}  // namespace
}  // namespace rotatebook::pipeline
