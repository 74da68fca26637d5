// Clips that show what they say.
#include "pipeline/verify/verify_clip.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "pipeline/small_clip.h"
#include "pipeline/verify/forged_clip.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using scene::testing::smallScene;
using ::testing::ElementsAre;
using testing::emptyFolder;
using testing::failedIn;
using ::testing::Gt;
using ::testing::IsEmpty;
using testing::kFrames;
using testing::proved;
using testing::shownScene;
using testing::verified;
using testing::writeClip;
using video::VideoFormat;

TEST(VerifyClip, ProvesWhatARenderMade) {
  const fs::path folder = emptyFolder();
  testing::render(
      shownScene(),
      {.folder = folder, .outputs = outputsOf(false, {VideoFormat::Mp4, VideoFormat::WebM})});
  for (const char* name : {"small.mp4", "small.webm"}) {
    const Verification found = verifyClip(folder / name, {.allFrames = true});
    EXPECT_TRUE(proved(found)) << name;
    EXPECT_THAT(found.toolsDiffer, IsEmpty());
    EXPECT_EQ(found.checks.size(), 19U);
    EXPECT_EQ(found.pictures.size(), static_cast<std::size_t>(kFrames));
    EXPECT_EQ(found.range, (store::FrameRange{0, kFrames}));
  }
}

TEST(VerifyClip, ComparesTheCaptionsBesideIt) {
  const fs::path folder = emptyFolder();
  testing::render(shownScene({"cue=[{ at = 0.2, text = 'Now' }]"}),
                  {.folder = folder, .outputs = outputsOf(false, {VideoFormat::Mp4})});
  EXPECT_TRUE(proved(verifyClip(folder / "small.mp4", {.frames = {0}})));
  std::ofstream(folder / "small.vtt", std::ios::app) << "\n";
  EXPECT_THAT(failedIn(verifyClip(folder / "small.mp4", {.frames = {0}})), ElementsAre("captions"));
  fs::remove(folder / "small.vtt");
  EXPECT_TRUE(proved(verifyClip(folder / "small.mp4", {.frames = {0}}))) << "it may lie elsewhere";
}

TEST(VerifyClip, FindsOtherChapters) {
  const auto said = shownScene({"cue=[{ at = 0.2, chapter = 'Flip' }]"});
  EXPECT_THAT(failedIn(verified({.said = said, .shown = said})), IsEmpty());
  EXPECT_THAT(
      failedIn(verified({.said = said,
                         .shown = said,
                         .change = [](auto& settings) { settings.chapters[0].name = "Flop"; }})),
      ElementsAre("layout"));
}

double meanRms(const Verification& found) {
  double sum = 0;
  for (const PictureCheck& picture : found.pictures) sum += picture.measured.rms;
  return sum / static_cast<double>(found.pictures.size());
}

// Of WebM no scene says how good it is: as good as an MP4 whose scene says nothing either.
TEST(VerifyClip, FindsAWebMAsGoodAsAnMp4) {
  constexpr double kAsGood = 0.25;  // measured 0.015; 0.54 at a constant quality of 34, not 24
  const fs::path folder = emptyFolder();
  testing::render(
      shownScene(),
      {.folder = folder, .outputs = outputsOf(false, {VideoFormat::Mp4, VideoFormat::WebM})});
  const double mp4 = meanRms(verifyClip(folder / "small.mp4", {.allFrames = true}));
  const double webm = meanRms(verifyClip(folder / "small.webm", {.allFrames = true}));
  EXPECT_NEAR(webm / mp4, 1, kAsGood);
}

class VerifyClipOf : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(VerifyClipOf, EverySceneIsProved) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = shownScene(GetParam());
  const auto format = scene::isTransparent(scene) ? VideoFormat::WebM : VideoFormat::Mp4;
  const auto result =
      testing::render(scene, {.folder = folder, .outputs = outputsOf(false, {format})});
  const Verification found = verifyClip(result.files.video(format), {.allFrames = true});
  EXPECT_TRUE(proved(found)) << ::testing::PrintToString(failedIn(found));
  EXPECT_THAT(found.pictures.size(), Gt(10U));
  for (const PictureCheck& picture : found.pictures) {
    EXPECT_TRUE(picture.passed()) << picture.frame << ": " << picture.measured.rms << ", "
                                  << picture.measured.worstBlock;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, VerifyClipOf,
    ::testing::Values(
        std::vector<std::string>{"clip.fps=\"30000/1001\""},
        std::vector<std::string>{"video.crf=1"},
        std::vector<std::string>{"video.crf=21", "video.preset=medium"},
        std::vector<std::string>{"clip.size=[64, 36]"},
        std::vector<std::string>{"look.background=stars",
                                 "overlay.show=['clock','axes','omega','energy']"},
        std::vector<std::string>{"look.background=transparent"},
        std::vector<std::string>{"look.background='#2b5d8a'", "video.crf=1"},
        std::vector<std::string>{"look.background='#2b5d8a'", "clip.size=[1280, 720]"},
        std::vector<std::string>{"look.motion_blur=4"},
        std::vector<std::string>{"cue=[{ text = 'Now', at = 0.2, hold = 0.1, chapter = 'A' }]",
                                 "overlay.show=['caption', 'clock']"},
        std::vector<std::string>{"initial.angular_velocity=[0.2, 0, 0]"},
        // Held pictures are copied whole, which x264 states as the quantiser 11.
        std::vector<std::string>{"video.preset=veryfast", "look.background=white",
                                 "clip.size=[320, 180]", "clip.fps=60", "clip.duration=0.2",
                                 "clip.speed=[{ from = 0.03, to = 0.1, value = 0 }]"},
        std::vector<std::string>{"simulation.model=particles", "simulation.substeps=1",
                                 "simulation.normalize=false", "simulation.damping=0"}));

// Still texture is coded finely, and says little of the noise in the rest.
TEST(VerifyClip, ProvesASmallBookAmongStars) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = smallScene(
      {"clip.size=[640, 360]", "clip.fps=60", "clip.duration=0.3", "look.background=stars",
       "initial.angular_velocity=[0.1, 3, 0.1]", "camera.position=[0, 0, 6]",
       "overlay.show=['caption', 'clock', 'polhode', 'energy', 'half_turns']"});
  testing::render(scene, {.folder = folder, .outputs = outputsOf(false, {VideoFormat::WebM})});
  EXPECT_TRUE(proved(verifyClip(folder / "small.webm", {.allFrames = true})));
}

// x264 codes letters far more coarsely than the rest.
TEST(VerifyClip, ProvesLettersInAFineClip) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene =
      smallScene({"title='A book thrown about its middle axis'", "clip.size=[640, 360]",
                  "clip.fps=240", "clip.duration=0.007", "video.crf=3", "video.preset=medium",
                  "caption='Spun one degree off that axis, it turns over again and again.'",
                  "overlay.show=['caption']"});
  testing::render(scene, {.folder = folder, .outputs = outputsOf(false, {VideoFormat::Mp4})});
  EXPECT_TRUE(proved(verifyClip(folder / "small.mp4", {.allFrames = true})));
}

// The letters stand still, and are coded finely; the shade of the book isn't.
TEST(VerifyClip, ProvesALetteredWebMOfManyFrames) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene =
      smallScene({"title='A book thrown about its middle axis'", "clip.size=[640, 360]",
                  "clip.fps=240", "clip.duration=0.1", "camera.position=[0, 0, 1.5]",
                  "caption='Spun one degree off that axis, it turns over again and again. Nothing "
                  "touches it.'",
                  "overlay.show=['caption']"});
  testing::render(scene, {.folder = folder, .outputs = outputsOf(false, {VideoFormat::WebM})});
  EXPECT_TRUE(proved(verifyClip(folder / "small.webm", {.allFrames = true})));
}

// Little changes and few edges show: pictures are copied, and seem to be shifted.
TEST(VerifyClip, ProvesATinyBook) {
  const auto isProved = [](std::vector<std::string> settings, VideoFormat format) {
    settings.insert(settings.begin(), {"clip.size=[160, 90]", "clip.duration=0.1"});
    const auto made = testing::render(
        smallScene(settings), {.folder = emptyFolder(), .outputs = outputsOf(false, {format})});
    return proved(verifyClip(made.files.video(format), {.allFrames = true}));
  };
  EXPECT_TRUE(isProved({"look.background='#2b5d8a'", "camera.position=[0, 0, 16]", "clip.fps=30",
                        "video.crf=22", "initial.angular_velocity=[4, 0, 0.1]"},
                       VideoFormat::Mp4));
  EXPECT_TRUE(isProved({"look.background=black", "camera.position=[0, 0, 2]", "clip.fps=144",
                        "initial.angular_velocity=[4, 0, 1]"},
                       VideoFormat::WebM));
}

class VerifyCoarseClipOf : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(VerifyCoarseClipOf, EachIsConsistent) {
  const fs::path folder = emptyFolder();
  const auto result = testing::render(
      shownScene(GetParam()), {.folder = folder, .outputs = outputsOf(false, {VideoFormat::Mp4})});
  const Verification found = verifyClip(result.files.video(VideoFormat::Mp4), {.allFrames = true});
  EXPECT_EQ(found.verdict(), Verdict::Coarse);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, VerifyCoarseClipOf,
    ::testing::Values(std::vector<std::string>{"video.crf=30", "video.preset=medium"},
                      std::vector<std::string>{"video.crf=51"},
                      std::vector<std::string>{"video.crf=42", "video.preset=medium",
                                               "clip.fps=1000", "clip.duration=0.1"}));

TEST(VerifyClip, ProvesPartsAndWhatAssembleMakesOfThem) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), testing::pngAndMp4(folder, {}, store::FrameRange{3, 9}));
  const fs::path part = folder / "small_00003-00009.mp4";
  const Verification found = verifyClip(part, {});
  EXPECT_TRUE(proved(found));
  EXPECT_EQ(found.range, (store::FrameRange{3, 9}));
  EXPECT_EQ(found.wholeCount, kFrames);
  ASSERT_EQ(found.pictures.size(), 6U);
  EXPECT_EQ(found.pictures.front().frame, 3);
  EXPECT_EQ(found.pictures.back().frame, 8);
  EXPECT_THROW(verifyClip(part, {.frames = {2}}), InputError);
}

TEST(VerifyClip, ComparesOneOfEachSixthUnlessAsked) {
  const fs::path path = emptyFolder() / "clip.mp4";
  writeClip({.said = smallScene(), .shown = smallScene()}, path);
  const auto framesOf = [&](const VerifyOptions& options) {
    std::vector<std::int64_t> frames;
    for (const PictureCheck& check : verifyClip(path, options).pictures) {
      frames.push_back(check.frame);
    }
    return frames;
  };
  const std::vector<std::int64_t> chosen = framesOf({});
  ASSERT_EQ(chosen.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(chosen[i] / 2, static_cast<std::int64_t>(i));
  EXPECT_EQ(framesOf({}), chosen);
  const scene::Scene other = smallScene({"initial.angular_velocity=[5, 3, 2]"});
  writeClip({.said = other, .shown = other}, path);
  EXPECT_NE(framesOf({}), chosen);
  EXPECT_THAT(framesOf({.frames = {7, 2, 7}}), ElementsAre(2, 7));
  EXPECT_EQ(testing::messageOf<InputError>([&] {
              framesOf({.frames = {3, 12}});
            }),
            "frame 12 isn't in the clip, which has 0 to 11");
}

}  // namespace
}  // namespace rotatebook::pipeline
