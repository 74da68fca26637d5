// Frames, records and files that a render finds and must not lose.
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "messages.h"
#include "pipeline/rendered_again.h"
#include "store/manifest.h"
#include "store/other_settings.h"
#include "system/atomic_file.h"
#include "system/temporary_files.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::bytesOf;
using ::testing::ElementsAre;
using testing::kFrames;
using testing::kOverwrite;
using testing::kResume;
using testing::messageOf;
using testing::otherScene;
using testing::smallScene;

class ForeignFiles : public testing::RenderedAgain {
 protected:
  RenderResult renderVideo(const store::EarlierFrames& earlier = {}) {
    return RenderedAgain::renderVideo(video::VideoFormat::Mp4, earlier, smallScene());
  }
  RenderResult renderPart(store::FrameRange range) {
    return testing::render(smallScene(),
                           {.folder = folder_, .outputs = {pngOutput()}, .frames = range});
  }
  fs::path write(const std::string& name) const {
    std::ofstream(folder_ / name) << "mine";
    return folder_ / name;
  }
  /// Expects that the part's five frames are neither discarded nor drawn again unasked.
  void expectPartsKept() {
    EXPECT_MESSAGE(failureOf({}));
    EXPECT_MESSAGE(failureOf({}, otherScene()));
    EXPECT_EQ(render(kResume).framesKept, 5);
    expectAsUninterrupted();
  }
};

TEST_F(ForeignFiles, LeavePartsUnfinishedBesideAVideoAlone) {
  renderPart({0, 5});
  renderVideo();
  EXPECT_TRUE(renderVideo(kResume).wasDone);
  expectPartsKept();
}

TEST_F(ForeignFiles, LeavePartsUnfinishedAfterAVideoAlone) {
  renderVideo();
  renderPart({0, 5});
  expectPartsKept();
}

TEST_F(ForeignFiles, LeaveFramesUnfinishedThatGoOnAfterAVideoAlone) {
  renderVideo();
  stop(5, kResume);
  expectPartsKept();
}

TEST_F(ForeignFiles, AreFramesBesideTheManifestOfAVideoAlone) {
  renderVideo();
  const fs::path frame = write("small/frame_00001.png");
  for (const auto& earlier : {store::EarlierFrames{}, kResume}) EXPECT_MESSAGE(failureOf(earlier));
  EXPECT_MESSAGE(messageOf<InputError>([&] { renderPart({0, 3}); }));
  renderVideo();
  EXPECT_EQ(bytesOf(frame), "mine");
  render(kOverwrite);
  expectAsUninterrupted();
}

TEST_F(ForeignFiles, AreFramesThatWereAddedOrChanged) {
  render({});
  const fs::path added = write("small/frame_00077.png");
  EXPECT_MESSAGE(failureOf({}, otherScene()));
  fs::remove(added);
  const fs::path changed = write("small/frame_00005.png");
  EXPECT_MESSAGE(failureOf({}));
  EXPECT_EQ(bytesOf(changed), "mine");
  EXPECT_EQ(render(kResume).framesKept, kFrames - 1) << "it was asked to go on";
  expectAsUninterrupted();
}

TEST_F(ForeignFiles, AreRecordsBesideAManifest) {
  render({});
  const fs::path record = write("small/scene.toml");
  const std::string problem = "holds a scene.toml that no render left there";
  EXPECT_MESSAGE(failureOf({}));
  EXPECT_MESSAGE(failureOf(kResume));
  EXPECT_MESSAGE(failureOf({}, otherScene()));
  EXPECT_MESSAGE(messageOf<InputError>([&] { renderVideo(); }));
  EXPECT_MESSAGE(messageOf<InputError>([&] { renderPart({0, 3}); }));
  EXPECT_EQ(bytesOf(record), "mine");
  render(kOverwrite);
  expectAsUninterrupted();
}

TEST_F(ForeignFiles, AreRecordsInAFolderThatIsNotNeeded) {
  render({});
  fs::create_directories(folder_ / "small.partial");
  const fs::path record = write("small.partial/scene.toml");
  write("small.partial/frames.manifest");
  EXPECT_TRUE(render(kResume).wasDone);
  EXPECT_EQ(bytesOf(record), "mine");
}

TEST_F(ForeignFiles, AreOfUnknownOriginWithoutAManifest) {
  fs::create_directories(folder_ / "small");
  write("small/frame_00000.png");
  EXPECT_MESSAGE(failureOf({}));
}

TEST_F(ForeignFiles, AreAFileInThePlaceOfTheReplacedFolder) {
  fs::create_directories(folder_);
  const fs::path file = write("small.replaced");
  EXPECT_MESSAGE(failureOf(kOverwrite));
  EXPECT_EQ(bytesOf(file), "mine");
  EXPECT_THAT(testing::namesIn(folder_), ElementsAre("small.replaced"));
}

TEST_F(ForeignFiles, AreReportedWhereTheyReplacedAnOutput) {
  render({});
  write("small.csv");
  EXPECT_MESSAGE(messageOf<InputError>([&] { render({}); }));
  EXPECT_THAT(render({.overwrite = true}).replaced,
              ElementsAre((folder_ / "small.csv").string() + store::kUnknownSettings));
}

TEST_F(ForeignFiles, AreCaptionsOfOthers) {
  const scene::Scene scene = smallScene({"cue=[{ at = 0.2, text = 'Now' }]"});
  render({}, scene);
  fs::remove_all(folder_ / "small");  // No manifest tells whose they are
  render({}, scene);
  write("small.vtt");
  EXPECT_MESSAGE(failureOf({}, scene));
  EXPECT_EQ(bytesOf(folder_ / "small.vtt"), "mine");
  render({});
  EXPECT_EQ(bytesOf(folder_ / "small.vtt"), "mine") << "the scene has no cues";
}

TEST_F(ForeignFiles, AreFoldersInTheWayFoundBeforeTheFirstFrame) {
  const auto failure = [&] { return messageOf<MachineError>([&] { renderVideo(); }); };
  fs::create_directories(folder_ / "small.partial.mp4/more");
  EXPECT_MESSAGE(failure());
  fs::remove_all(folder_ / "small.partial.mp4");
  fs::create_directories(folder_ / "small" / store::kManifestName);
  EXPECT_MESSAGE(failure());
  EXPECT_FALSE(fs::exists(folder_ / "small.csv"));
}

// Two clips may have a table of the same name.
TEST_F(ForeignFiles, AreNotWrittenByTwoRendersAtOnce) {
  fs::create_directories(folder_);
  const system::AdvisoryLock other(folder_ / "small.csv", system::Lock::Exclusive);
  EXPECT_MESSAGE(messageOf<MachineError>([&] { render({}); }));
}

TEST_F(ForeignFiles, ArentWhatAKilledRenderLeft) {
  render({}, otherScene());
  fs::create_directory(folder_ / "small.partial");
  render(kResume);
  expectAsUninterrupted();
  // A process of this machine that has ended
  std::string left = system::temporaryNameFor("small.mp4");
  write(left.replace(left.rfind('-'), std::string::npos, "-99999999"));
  EXPECT_TRUE(render(kResume).wasDone);
  expectAsUninterrupted();
}

}  // namespace
}  // namespace rotatebook::pipeline
