#include "pipeline/render_clip.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/same_bytes.h"
#include "image/comparison.h"
#include "image/png_file.h"
#include "pipeline/small_clip.h"
#include "store/clip_record.h"
#include "store/manifest.h"
#include "system/file_checksum.h"
#include "timeline/simulate_scene.h"
#include "timeline/trajectory_csv.h"
#include "video/decoded_video.h"
#include "video/video_writer.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using rotatebook::testing::sameBytes;
using testing::bytesOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::emptyFolder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kFrames;
using testing::motionOf;
using testing::namesIn;
using testing::pngAndMp4;
using testing::smallScene;
using testing::stoppedAfter;
using video::testing::DecodedVideo;
using video::testing::decodeVideo;

// The names of `count` frames and what tells of them.
std::vector<std::string> frameFolderNames(std::int64_t count) {
  std::vector<std::string> names;
  for (std::int64_t index = 0; index < count; ++index) names.push_back(store::frameName(index));
  for (const char* name : {"frames.manifest", "frames.xxh128", "scene.toml"}) names.push_back(name);
  return names;
}

bool sameColours(const image::Image& a, const image::Image& b) {
  return image::compare(a.view(), b.view(), {}).same;
}

TEST(RenderClip, LeavesItsFilesAndNoOthers) {
  const fs::path folder = emptyFolder();
  const RenderResult result = testing::render(smallScene(), pngAndMp4(folder));
  EXPECT_THAT(namesIn(folder),
              ElementsAre("small", "small.csv", "small.json", "small.mp4", "small.poster.png"));
  EXPECT_EQ(namesIn(folder / "small"), frameFolderNames(kFrames));
  EXPECT_EQ(result.framesWritten, kFrames);
  EXPECT_FALSE(result.interrupted);
  EXPECT_EQ(result.files.video(video::VideoFormat::Mp4), folder / "small.mp4");
  EXPECT_EQ(result.files.csv, folder / "small.csv");
  EXPECT_EQ(result.files.frameFolder, folder / "small");
}

TEST(RenderClip, LeavesCaptionsAndChaptersOfItsCues) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene(
      {"cue=[{ text = 'Wait', chapter = 'Start' }, { at = 0.2, text = 'Now', hold = 0.1, chapter = "
       "'Nudged' }]",
       "nudge=[{ at = 0.1, angular_velocity = [0, 0, 1] }]"});
  const RenderResult result = testing::render(scene, pngAndMp4(folder));
  EXPECT_EQ(bytesOf(folder / "small.vtt"),
            "WEBVTT rotatebook\n\n00:00:00.000 --> 00:00:00.250 line:0\nWait\n\n"
            "00:00:00.125 --> 00:00:00.500 line:0\n0.10 s: nudge 1\n\n"
            "00:00:00.250 --> 00:00:00.500 line:0\nNow\n");
  EXPECT_THAT(decodeVideo(folder / "small.mp4").chapters, ElementsAre("0.00 Start", "0.25 Nudged"));
  EXPECT_THAT(store::outputFiles(result.files, scene, {}), Contains(folder / "small.vtt"));
}

TEST(RenderClip, MakesItsFolders) {
  const fs::path start = emptyFolder(), folder = start / "a" / "b";
  testing::render(smallScene(), pngAndMp4(folder));
  EXPECT_THAT(namesIn(start), ElementsAre("a"));
  EXPECT_THAT(namesIn(start / "a"), ElementsAre("b"));
  EXPECT_THAT(namesIn(folder),
              ElementsAre("small", "small.csv", "small.json", "small.mp4", "small.poster.png"));
  EXPECT_EQ(namesIn(folder / "small"), frameFolderNames(kFrames));
}

TEST(RenderClip, DrawsFrameNFromSampleN) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene();
  testing::render(scene, {.folder = folder, .outputs = {pngOutput()}});
  const physics::Trajectory trajectory = motionOf(scene);
  render::Renderer renderer = picture::makeRenderer(scene);
  image::Image expected = renderer.makePicture();
  image::Image before = renderer.makePicture();
  for (std::size_t n = 0; n < trajectory.samples.size(); ++n) {
    renderer.draw(trajectory.samples[n].cage, expected);
    const image::Image read =
        image::readPng(folder / "small" / store::frameName(static_cast<std::int64_t>(n)));
    EXPECT_TRUE(sameColours(read, expected)) << "frame " << n;
    EXPECT_FALSE(sameColours(read, before)) << "frame " << n << " is like the one before";
    before = expected;
  }
}

TEST(RenderClip, StartsWithTheBookAtRest) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene();
  testing::render(scene, {.folder = folder, .outputs = {pngOutput()}});
  render::Renderer renderer = picture::makeRenderer(scene);
  image::Image expected = renderer.makePicture();
  renderer.draw(scene.motions[0].body.corners(), expected);
  EXPECT_TRUE(sameColours(image::readPng(folder / "small" / store::frameName(0)), expected));
}

TEST(RenderClip, RemovesNoVideoThatItDoesNotReplace) {
  using video::VideoFormat;
  const fs::path folder = emptyFolder();
  testing::render(
      smallScene(),
      {.folder = folder, .outputs = outputsOf(true, {VideoFormat::Gif, VideoFormat::WebM})});
  const std::string gif = bytesOf(folder / "small.gif"), webm = bytesOf(folder / "small.webm");
  const RenderResult result =
      testing::render(smallScene({"initial.angular_velocity=[1, 2, 3]"}),
                      {.folder = folder, .outputs = outputsOf(true, {VideoFormat::WebM})});
  EXPECT_TRUE(sameBytes(bytesOf(folder / "small.gif"), gif));
  EXPECT_FALSE(bytesOf(folder / "small.webm") == webm);
  EXPECT_THAT(result.others, ElementsAre((folder / "small.gif").string()));
}

TEST(RenderClip, WritesTheMotionAsCsv) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), {.folder = folder, .outputs = outputsOf(false, {})});
  EXPECT_EQ(bytesOf(folder / "small.csv"), timeline::trajectoryCsv(motionOf(smallScene())));
}

TEST(RenderClip, MakesAVideoOfTheRightLength) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder));
  const DecodedVideo video = decodeVideo(folder / "small.mp4");
  EXPECT_EQ(video.width, 64);
  EXPECT_EQ(video.height, 36);
  EXPECT_EQ(video.frames.size(), static_cast<std::size_t>(kFrames));
  EXPECT_EQ(video.frameCount, kFrames);
  EXPECT_EQ(video.containerDurationUs, 500000);
}

TEST(RenderClip, RecordsInTheVideoWhatItWasMadeFrom) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder));
  const DecodedVideo video = decodeVideo(folder / "small.mp4");
  EXPECT_EQ(video.metadata.at("title"), "Small · clip");
  const std::string record = bytesOf(folder / "small" / "scene.toml");
  EXPECT_EQ(video.metadata.at("comment"), store::recordOfVideo(record, video::ffmpegVersion()));
  EXPECT_THAT(record,
              HasSubstr("# Renderer: " + picture::makeRenderer(smallScene()).description()));
  EXPECT_EQ(scene::sceneText(scene::parseScene(record, "small.toml")),
            scene::sceneText(smallScene()));
}

// Mean difference in luma between a decoded picture and a PNG, BT.709 limited range.
double lumaDifference(const video::testing::DecodedFrame& frame, const image::Image& picture) {
  double sum = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const auto* pixel = picture.row(y) + x * image::bytesPerPixel(picture.format());
      const double luma = 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2];
      const auto at = static_cast<std::size_t>(y * picture.width() + x);
      sum += std::abs(frame.y.at(at) - (16 + luma * 219 / 255));
    }
  }
  return sum / (picture.width() * picture.height());
}

TEST(RenderClip, MakesTheVideoOfThePngsPictures) {
  constexpr double kAlike = 1;      // measured 0.44 at crf 1
  constexpr double kDifferent = 3;  // measured 5.3 between neighbours, at least
  const fs::path folder = emptyFolder();
  testing::render(smallScene({"video.crf=1"}), pngAndMp4(folder));
  const DecodedVideo video = decodeVideo(folder / "small.mp4");
  ASSERT_EQ(video.frames.size(), static_cast<std::size_t>(kFrames));
  for (std::size_t n = 0; n < video.frames.size(); ++n) {
    const std::size_t other = n == 0 ? 1 : n - 1;
    const image::Image picture =
        image::readPng(folder / "small" / store::frameName(static_cast<std::int64_t>(n)));
    EXPECT_LT(lumaDifference(video.frames[n], picture), kAlike) << "frame " << n;
    EXPECT_GT(lumaDifference(video.frames[other], picture), kDifferent) << "frame " << n;
  }
}

TEST(RenderClip, GivesTheSameBytesAgain) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder / "a"));
  testing::render(smallScene(), pngAndMp4(folder / "b"));
  for (const char* name : {"small.mp4", "small.csv"}) {
    EXPECT_TRUE(sameBytes(bytesOf(folder / "a" / name), bytesOf(folder / "b" / name))) << name;
  }
  for (const std::string& name : frameFolderNames(kFrames)) {
    EXPECT_TRUE(sameBytes(bytesOf(folder / "a/small" / name), bytesOf(folder / "b/small" / name)))
        << name;
  }
}

TEST(RenderClip, LeavesOutWhatIsNotWanted) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), {.folder = folder / "mp4",
                                 .outputs = outputsOf(false, {video::VideoFormat::Mp4})});
  EXPECT_THAT(namesIn(folder / "mp4"),
              ElementsAre("small", "small.csv", "small.json", "small.mp4", "small.poster.png"));
  testing::render(smallScene(), {.folder = folder / "png", .outputs = {pngOutput()}});
  EXPECT_THAT(namesIn(folder / "png"),
              ElementsAre("small", "small.csv", "small.json", "small.poster.png"));
  testing::render(smallScene(), pngAndMp4(folder / "both"));
  EXPECT_EQ(bytesOf(folder / "mp4/small.mp4"), bytesOf(folder / "both/small.mp4"));
}

TEST(RenderClip, RemovesTheFramesOfALongerRenderBefore) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder));
  const scene::Scene shorter = smallScene({"clip.duration=0.25"});
  testing::render(shorter, pngAndMp4(folder));
  EXPECT_EQ(namesIn(folder / "small"), frameFolderNames(6));
  EXPECT_EQ(decodeVideo(folder / "small.mp4").frames.size(), 6U);
}

TEST(RenderClip, ReportsRendererEncoderAndProgress) {
  const fs::path folder = emptyFolder();
  RenderStart start;
  std::vector<std::int64_t> done;
  const RenderListener listener{[&](const RenderStart& begun) { start = begun; },
                                [&](RenderProgress progress) { done.push_back(progress.done); }};
  renderClip(smallScene(), timeline::simulateScene(smallScene()),
             {.folder = folder, .outputs = {pngOutput(3), videoOutput(video::VideoFormat::Mp4)}},
             listener);
  EXPECT_THAT(start.renderer, HasSubstr("OpenGL"));
  EXPECT_FALSE(start.encoders.empty());
  EXPECT_EQ(start.pngThreads, 3);
  ASSERT_EQ(done.size(), static_cast<std::size_t>(kFrames) + 1);
  EXPECT_EQ(done.front(), 0);
  EXPECT_EQ(done.back(), kFrames);
}

TEST(RenderClip, LeavesAPlayablePartialVideoWhenStopped) {
  const fs::path folder = emptyFolder();
  const RenderResult result = stoppedAfter(5, smallScene(), pngAndMp4(folder));
  EXPECT_TRUE(result.interrupted);
  EXPECT_EQ(result.framesWritten, 5);
  EXPECT_THAT(namesIn(folder), ElementsAre("small.partial", "small.partial.mp4"));
  EXPECT_EQ(decodeVideo(folder / "small.partial.mp4").frames.size(), 5U);
  EXPECT_EQ(namesIn(folder / "small.partial"), frameFolderNames(5));
}

TEST(RenderClip, LeavesNoVideoWhenStoppedBeforeTheFirstFrame) {
  const fs::path folder = emptyFolder();
  const RenderResult result = stoppedAfter(0, smallScene(), pngAndMp4(folder));
  EXPECT_TRUE(result.interrupted);
  EXPECT_THAT(namesIn(folder), IsEmpty());
}

TEST(RenderClip, KeepsAllOfAnEarlierRenderWhenStopped) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder));
  const std::string video = bytesOf(folder / "small.mp4");
  const std::string table = bytesOf(folder / "small.csv");
  stoppedAfter(5, smallScene(), pngAndMp4(folder));
  EXPECT_EQ(bytesOf(folder / "small.mp4"), video);
  EXPECT_EQ(bytesOf(folder / "small.csv"), table);
  EXPECT_EQ(namesIn(folder / "small"), frameFolderNames(kFrames));
}

TEST(RenderClip, KeepsWhatTheSameSettingsMadeBefore) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder));
  testing::render(smallScene(),
                  {.folder = folder, .outputs = outputsOf(false, {video::VideoFormat::Mp4})});
  testing::render(smallScene(), {.folder = folder, .outputs = {pngOutput()}});
  EXPECT_THAT(namesIn(folder),
              ElementsAre("small", "small.csv", "small.json", "small.mp4", "small.poster.png"));
  EXPECT_EQ(namesIn(folder / "small"), frameFolderNames(kFrames));
}

TEST(RenderClip, NamesTheTexturesThatItDrewThoughTheFileIsReplaced) {
  const fs::path folder = emptyFolder(), cover = folder / "cover.png";
  scene::Scene scene = smallScene({"book.front=cover.png"});
  scene.folder = folder;
  image::Image picture(4, 4, image::PixelFormat::Rgb8);
  image::writePng(cover, picture.view());
  const std::string drawn = system::checksumOfFile(cover);
  RenderListener listener;
  listener.started = [&](const RenderStart&) {
    picture.row(0)[0] ^= 1;
    image::writePng(cover, picture.view());
  };
  renderClip(scene, timeline::simulateScene(scene), pngAndMp4(folder), listener);
  EXPECT_NE(system::checksumOfFile(cover), drawn);
  EXPECT_EQ(store::readManifest(folder / "small")->own.made.at("book.front"), drawn);
  EXPECT_THAT(bytesOf(folder / "small" / "scene.toml"),
              HasSubstr("\n# Textures: book.front " + drawn + "\n"));
}

TEST(RenderClip, RemovesThePartialVideoOnceItIsWhole) {
  const fs::path folder = emptyFolder();
  stoppedAfter(5, smallScene(), pngAndMp4(folder));
  testing::render(smallScene(), pngAndMp4(folder, {.overwrite = true}));
  EXPECT_THAT(namesIn(folder),
              ElementsAre("small", "small.csv", "small.json", "small.mp4", "small.poster.png"));
}

TEST(RenderClip, HoldsItsLastPictureForASecondAfterTheMotionDiverges) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = testing::divergingScene();
  const physics::Trajectory trajectory = motionOf(scene);
  const auto count = static_cast<std::int64_t>(trajectory.samples.size());
  ASSERT_TRUE(trajectory.divergedAt.has_value());
  ASSERT_LT(count, kFrames);
  ASSERT_GT(count, 1);
  const std::int64_t frames = count + 24;
  EXPECT_EQ(testing::render(scene, pngAndMp4(folder)).framesWritten, frames);
  EXPECT_EQ(namesIn(folder / "small"), frameFolderNames(frames));
  EXPECT_EQ(decodeVideo(folder / "small.mp4").frameCount, frames);
  const auto frame = [&](std::int64_t n) {
    return bytesOf(folder / "small" / store::frameName(n));
  };
  EXPECT_NE(frame(count), frame(count - 2));
  EXPECT_EQ(frame(count), frame(frames - 1));
  const std::string csv = bytesOf(folder / "small.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), count + 1);
}

}  // namespace
}  // namespace rotatebook::pipeline
