// Clips that don't show what they say: what verify finds in them.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/small_clip.h"
#include "pipeline/verify/forged_clip.h"
#include "pipeline/verify/picture_comparison.h"
#include "pipeline/verify/verify_clip.h"
#include "video/forged_mp4.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using scene::testing::smallScene;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::emptyFolder;
using testing::expectWrongPictures;
using testing::failedIn;
using testing::Forgery;
using ::testing::IsEmpty;
using testing::kFrames;
using testing::proved;
using testing::shownScene;
using testing::verified;
using testing::writeClip;
using testing::wrongPictures;

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
    writeClip({.said = smallScene(), .shown = smallScene()}, path);
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
