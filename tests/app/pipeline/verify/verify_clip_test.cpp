// Clips that show what they say, and clips that don't.
#include "pipeline/verify/verify_clip.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "picture/frame_drawer.h"
#include "pipeline/small_clip.h"
#include "pipeline/verify/picture_comparison.h"
#include "store/encoding.h"
#include "timeline/motion_checksum.h"
#include "video/forged_mp4.h"
#include "video/video_writer.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using scene::testing::smallScene;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::emptyFolder;
using ::testing::Gt;
using ::testing::IsEmpty;
using testing::kFrames;
using video::VideoFormat;

/// smallScene() in pictures that show a degree.
scene::Scene shownScene(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), "clip.size=[320, 180]");
  return smallScene(overrides);
}

/// A clip that says it is of one scene, and shows another.
struct Forgery {
  scene::Scene said = shownScene();
  scene::Scene shown = shownScene();
  std::int64_t shift = 0;  ///< Frame n shows frame n + shift, as far as there is one.
  std::int64_t frames = kFrames;
  bool swapped = false;  ///< Red and blue.
  int brighter = 0;      ///< By how much each colour of each pixel is. [of 255]
  std::function<void(video::VideoSettings&)> change{};
  std::function<void(store::Provenance&)> made{};
};

void swapRedAndBlue(image::Image& picture) {
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* row = picture.row(y);
    for (int x = 0; x < picture.width(); ++x) std::swap(row[4 * x], row[4 * x + 2]);
  }
}

void brighten(image::Image& picture, int by) {
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* row = picture.row(y);
    for (int i = 0; i < 4 * picture.width(); ++i) {
      if (i % 4 != 3) row[i] = static_cast<std::uint8_t>(std::min(row[i] + by, 255));
    }
  }
}

void write(const Forgery& forgery, const fs::path& path) {
  const timeline::ClipMotion motion = timeline::simulateScene(forgery.shown);
  picture::FrameDrawer drawer(forgery.shown, motion);
  store::Provenance provenance = store::provenanceOf(
      forgery.said, timeline::motionChecksum(timeline::simulateScene(forgery.said)), {},
      drawer.description(), video::ffmpegVersion());
  if (forgery.made) forgery.made(provenance);
  video::VideoSettings settings =
      store::videoSettings(forgery.shown, store::sceneRecord(forgery.said, provenance));
  if (forgery.change) forgery.change(settings);
  video::VideoWriter writer(VideoFormat::Mp4, path, settings);
  image::Image picture = drawer.makePicture();
  for (std::int64_t n = 0; n < forgery.frames; ++n) {
    drawer.draw(std::clamp<std::int64_t>(n + forgery.shift, 0, kFrames - 1), picture);
    if (forgery.swapped) swapRedAndBlue(picture);
    if (forgery.brighter > 0) brighten(picture, forgery.brighter);
    writer.write(picture.view());
  }
  writer.finish();
}

Verification verified(const Forgery& forgery) {
  const fs::path path = emptyFolder() / "clip.mp4";
  write(forgery, path);
  return verifyClip(path, {.allFrames = true});
}

bool proved(const Verification& found) {
  return found.verdict() == Verdict::Proved;
}

std::vector<std::string> failedIn(const Verification& found) {
  std::vector<std::string> names;
  for (const ClipCheck& check : found.checks) {
    if (!check.passed) names.push_back(check.what);
  }
  return names;
}

std::int64_t wrongPictures(const Verification& found) {
  return std::ranges::count(found.pictures, false, &PictureCheck::passed);
}

/// Expects that only pictures are wrong, and all of them.
void expectWrongPictures(const Verification& found) {
  EXPECT_FALSE(proved(found));
  EXPECT_THAT(failedIn(found), IsEmpty());
  EXPECT_EQ(wrongPictures(found), kFrames);
}

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
  write({.said = smallScene(), .shown = smallScene()}, path);
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
  write({.said = other, .shown = other}, path);
  EXPECT_NE(framesOf({}), chosen);
  EXPECT_THAT(framesOf({.frames = {7, 2, 7}}), ElementsAre(2, 7));
  EXPECT_EQ(testing::messageOf<InputError>([&] {
              framesOf({.frames = {3, 12}});
            }),
            "frame 12 isn't in the clip, which has 0 to 11");
}

TEST(VerifyClip, NamesTheNeighbourThatAPictureBelongsTo) {
  for (const std::int64_t shift : {-1, 1, 3}) {
    const Verification found = verified({.shift = shift});
    EXPECT_THAT(failedIn(found), IsEmpty());
    // The ends show what they should: there is none beyond.
    EXPECT_EQ(wrongPictures(found), kFrames - 1) << shift;
    for (const PictureCheck& picture : found.pictures) {
      const auto shown = std::clamp<std::int64_t>(picture.frame + shift, 0, kFrames - 1);
      if (shown == picture.frame) continue;
      EXPECT_EQ(picture.closerTo, shown) << picture.frame;
    }
  }
}

TEST(VerifyClip, FindsTheBookTurnedByADegree) {
  expectWrongPictures(verified({.shown = shownScene({"camera.up=[0.0174524, 0.9998477, 0]"})}));
}

TEST(VerifyClip, FindsAnotherScenesPictures) {
  const Verification found =
      verified({.shown = shownScene({"initial.angular_velocity=[4, 3, 1]"})});
  EXPECT_THAT(failedIn(found), IsEmpty());
  EXPECT_EQ(wrongPictures(found), kFrames - 1);  // They start alike.
  expectWrongPictures(verified({.shown = shownScene({"look.background=stars"})}));
}

TEST(VerifyClip, FindsSwappedColours) {
  expectWrongPictures(verified({.swapped = true}));
}

// The record says 18: how well the stream is coded is measured.
TEST(VerifyClip, ProvesNoCoarseStream) {
  const scene::Scene coarse = shownScene({"video.crf=40"});
  const Verification found = verified({.said = coarse, .shown = coarse});
  EXPECT_EQ(found.failures(), 0);
  EXPECT_EQ(found.verdict(), Verdict::Coarse);
  EXPECT_GT(found.quantiser, kCoarsestProof);  // measured 44
  EXPECT_GT(found.unnoticed().rms, encodingBound(kCoarsestProof, 320, 180).rms);
}

/// A clip whose record says that a browser made it, of another book: its pictures differ.
Forgery browsersClip() {
  return {.shown = shownScene({"look.background=stars"}), .made = [](store::Provenance& made) {
            made.renderer = "a browser, Chrome 1";
            made.ffmpeg.clear();
          }};
}

TEST(VerifyClip, ProvesTheMotionAloneOfABrowsersClip) {
  const Verification found = verified(browsersClip());
  EXPECT_THAT(failedIn(found), IsEmpty());
  EXPECT_THAT(found.pictures, IsEmpty());
  EXPECT_EQ(found.verdict(), Verdict::Motion);
}

TEST(VerifyClip, RefusesABrowsersClipOfAnotherMotionOrFewerPictures) {
  Forgery other = browsersClip();
  other.made = [made = other.made](store::Provenance& provenance) {
    made(provenance);
    provenance.motion.back() = provenance.motion.back() == '0' ? '1' : '0';
  };
  EXPECT_THAT(failedIn(verified(other)), ElementsAre("motion"));
  Forgery shorter = browsersClip();
  shorter.frames = kFrames - 1;
  const Verification found = verified(shorter);
  EXPECT_THAT(failedIn(found), ElementsAre("frames", "duration"));
  EXPECT_EQ(found.verdict(), Verdict::NotProved);
}

// The record's rate factor is the forger's: libx264's note has another, and the bounds are the
// stream's own.
TEST(VerifyClip, HoldsAFineStreamToItsOwnBounds) {
  const scene::Scene said = shownScene({"video.crf=51"});
  const Verification found = verified({.said = said});
  EXPECT_THAT(failedIn(found), ElementsAre("layout", "coding"));
  EXPECT_EQ(wrongPictures(found), 0);
  EXPECT_EQ(wrongPictures(verified({.said = said, .brighter = 7})), kFrames);
  EXPECT_EQ(wrongPictures(verified({.said = said, .swapped = true})), kFrames);
  EXPECT_FALSE(proved(verified({.said = said, .shown = said, .brighter = 7})));
}

// Neither the whole nor any patch of them is farther away than encoding explains: the mean is.
TEST(VerifyClip, FindsPicturesThatAreATouchTooBright) {
  const Verification found = verified({.brighter = 2});
  expectWrongPictures(found);
  for (const PictureCheck& picture : found.pictures) {
    EXPECT_LT(picture.measured.rms, 0.8 * picture.bound.rms);                // measured 0.58
    EXPECT_LT(picture.measured.worstBlock, 0.8 * picture.bound.worstBlock);  // measured 0.38
    EXPECT_GT(picture.measured.brightness, picture.bound.brightness);
    EXPECT_FALSE(picture.closerTo.has_value());
  }
}

TEST(VerifyClip, FindsAnotherMotion) {
  const Verification found =
      verified({.made = [](store::Provenance& provenance) { provenance.motion.back() ^= 1; }});
  EXPECT_THAT(failedIn(found), ElementsAre("motion"));
  EXPECT_EQ(found.failures(), 1);
  const Verification none =
      verified({.made = [](store::Provenance& provenance) { provenance.motion.clear(); }});
  EXPECT_THAT(failedIn(none), ElementsAre("motion"));
}

TEST(VerifyClip, FindsMissingAndAdditionalFrames) {
  EXPECT_THAT(failedIn(verified({.frames = kFrames - 1})),
              ElementsAre("frames", "duration", "layout"));
  EXPECT_THAT(failedIn(verified({.frames = kFrames + 1})),
              ElementsAre("frames", "duration", "layout"));
}

TEST(VerifyClip, FindsAnotherRate) {
  const Verification found = verified({.change = [](video::VideoSettings& settings) {
    settings.frameRate = {25, 1};
  }});
  EXPECT_THAT(failedIn(found), ElementsAre("time stamps", "duration", "layout", "coding"));
}

TEST(VerifyClip, ComparesNoPicturesOfAnotherSize) {
  const Verification found = verified({.said = smallScene()});
  EXPECT_THAT(failedIn(found), ElementsAre("size"));
  EXPECT_THAT(found.pictures, IsEmpty());
  EXPECT_FALSE(proved(found));
}

// Of these the decoded pictures are true.
TEST(VerifyClip, FindsWhatPlayersWouldShowOtherwise) {
  const std::string content = [] {
    const fs::path path = emptyFolder() / "true.mp4";
    write({.said = smallScene(), .shown = smallScene()}, path);
    return testing::bytesOf(path);
  }();
  namespace forged = video::testing;
  const std::vector<std::pair<std::vector<forged::BoxPatch>, std::string>> forgeries{
      {forged::kTurned, "display"},
      {forged::kMirrored, "display"},
      {forged::kWholeTurned, "display"},
      {forged::kStretched, "layout"},
      {forged::kWidePixels, "pixel shape"},
      {forged::kOtherColours, "container"},
      {forged::kFullRange, "container"},
      {forged::kFastEdit, "layout"},
      {forged::kFastMovie, "layout"},
      {forged::kCleanAperture, "layout"},
      {forged::kFields, "scan"}};
  const fs::path path = emptyFolder() / "forged.mp4";
  for (const auto& [patches, check] : forgeries) {
    std::ofstream(path, std::ios::binary) << forged::forgedMp4(content, patches);
    const std::vector<std::string> failed = failedIn(verifyClip(path, {}));
    EXPECT_THAT(failed, Contains("layout"));
    EXPECT_THAT(failed, Contains(check));
  }
  std::ofstream(path, std::ios::binary) << forged::forgedMp4(content, {});
  EXPECT_TRUE(proved(verifyClip(path, {})));
}

TEST(VerifyClip, FindsAnotherTitle) {
  const Verification found =
      verified({.change = [](video::VideoSettings& settings) { settings.title = "Another"; }});
  EXPECT_THAT(failedIn(found), ElementsAre("title"));
}

TEST(VerifyClip, FindsOtherWordsInTheRecord) {
  const Verification found = verified(
      {.change = [](video::VideoSettings& settings) { settings.comment += "# It lasts 8 s\n"; }});
  EXPECT_THAT(failedIn(found), ElementsAre("record"));
}

TEST(VerifyClip, NotesOtherTools) {
  const Verification found =
      verified({.made = [](store::Provenance& provenance) { provenance.renderer = "a card"; }});
  EXPECT_TRUE(proved(found));
  ASSERT_EQ(found.toolsDiffer.size(), 1U);
  EXPECT_THAT(found.toolsDiffer[0], ::testing::StartsWith("the renderer was a card, here it is "));
}

}  // namespace
}  // namespace rotatebook::pipeline
