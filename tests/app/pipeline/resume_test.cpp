// Renders that go on with what an earlier one left.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "image/image.h"
#include "image/png_file.h"
#include "messages.h"
#include "pipeline/rendered_again.h"
#include "pipeline/small_clip.h"
#include "store/manifest.h"
#include "system/temporary_files.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::bytesOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::emptyFolder;
using testing::expectSame;
using ::testing::HasSubstr;
using testing::kFrames;
using testing::kOverwrite;
using testing::kResume;
using testing::kResumeOrOverwrite;
using testing::messageOf;
using testing::namesIn;
using testing::otherScene;
using testing::pngAndMp4;
using testing::smallScene;
using testing::stoppedAfter;
using Resume = testing::RenderedAgain;

TEST_F(Resume, GivesTheBytesOfAnUninterruptedRender) {
  stop(3);
  EXPECT_EQ(stop(8, kResume).framesKept, 3);
  const RenderResult result = render(kResume);
  EXPECT_EQ(result.framesKept, 8);
  EXPECT_EQ(result.framesWritten, kFrames);
  expectAsUninterrupted();
}

TEST_F(Resume, GivesThemInEveryFormatWithPanelsAndAlpha) {
  using video::VideoFormat;
  const scene::Scene scene = smallScene({"look.background=transparent"});
  const RenderOptions options{.folder = folder_,
                              .outputs = outputsOf(true, {VideoFormat::WebM, VideoFormat::Apng})};
  stoppedAfter(5, scene, options);
  RenderOptions resumed = options;
  resumed.earlier = kResume;
  EXPECT_EQ(testing::render(scene, resumed).framesKept, 5);
  expectAsUninterrupted(options, scene);
}

TEST_F(Resume, DrawsDamagedAndMissingFramesAgain) {
  stop(6);
  std::ofstream(folder_ / "small.partial" / store::frameName(2), std::ios::app) << "x";
  fs::remove(folder_ / "small.partial" / store::frameName(4));
  EXPECT_EQ(render(kResume).framesKept, 4);
  expectAsUninterrupted();
}

TEST_F(Resume, SkipsWhatIsDone) {
  render({});
  const auto written = fs::last_write_time(folder_ / "small.mp4");
  EXPECT_TRUE(render(kResume).wasDone);
  EXPECT_EQ(fs::last_write_time(folder_ / "small.mp4"), written);
  EXPECT_FALSE(render({}).wasDone) << "without being asked";
  expectAsUninterrupted();
}

TEST_F(Resume, MakesAgainWhatIsDamaged) {
  render({});
  for (const char* name : {"small.mp4", "small.csv", "small.poster.png", "small/frame_00000.png",
                           "small/frame_00003.png", "small/frame_00011.png"}) {
    std::ofstream(folder_ / name, std::ios::app) << "x";
    EXPECT_FALSE(render(kResume).wasDone) << name;
    EXPECT_TRUE(render(kResume).wasDone) << name;
  }
  expectAsUninterrupted();
}

TEST_F(Resume, MakesAnotherFormatOfFramesThatAreThere) {
  render({});
  const RenderOptions gif{
      .folder = folder_,
      .outputs = outputsOf(true, {video::VideoFormat::Mp4, video::VideoFormat::Gif}),
      .earlier = kResume};
  EXPECT_EQ(testing::render(smallScene(), gif).framesKept, kFrames);
  expectAsUninterrupted({.outputs = gif.outputs});
}

TEST_F(Resume, EncodesVideosOfFramesThatWereDrawnWithoutFfmpeg) {
  testing::render(smallScene(), {.folder = folder_, .outputs = {pngOutput()}});
  EXPECT_EQ(render(kResume).framesKept, kFrames);
  expectAsUninterrupted();
}

TEST_F(Resume, OfFramesAloneDrawsWhatIsMissing) {
  const RenderOptions options{.folder = folder_, .outputs = {pngOutput()}, .earlier = kResume};
  stoppedAfter(4, smallScene(), options);
  EXPECT_EQ(testing::render(smallScene(), options).framesKept, 4);
  expectAsUninterrupted({.outputs = {pngOutput()}});
}

TEST_F(Resume, OfVideosAloneSkipsThemOrBeginsAnew) {
  const RenderOptions options{.folder = folder_,
                              .outputs = outputsOf(false, {video::VideoFormat::Mp4}),
                              .earlier = kResume};
  stoppedAfter(4, smallScene(), options);
  EXPECT_EQ(testing::render(smallScene(), options).framesKept, 0);
  EXPECT_TRUE(testing::render(smallScene(), options).wasDone);
  expectAsUninterrupted({.outputs = outputsOf(false, {video::VideoFormat::Mp4})});
}

TEST_F(Resume, OfAPartKeepsItsFrames) {
  const RenderOptions part = pngAndMp4(folder_, kResume, store::FrameRange{2, 8});
  stoppedAfter(3, smallScene(), part);
  EXPECT_EQ(testing::render(smallScene(), part).framesKept, 3);
}

TEST_F(Resume, MakesTheWholeOfParts) {
  for (const store::FrameRange range : {store::FrameRange{5, 12}, store::FrameRange{0, 5}}) {
    testing::render(smallScene(), {.folder = folder_, .outputs = {pngOutput()}, .frames = range});
  }
  EXPECT_EQ(render(kResume).framesKept, kFrames);
  expectAsUninterrupted();
}

TEST_F(Resume, TakesWhatAWholeAndAPartLeft) {
  stop(5);
  testing::render(smallScene(),
                  {.folder = folder_, .outputs = {pngOutput()}, .frames = store::FrameRange{3, 8}});
  EXPECT_EQ(render(kResume).framesKept, 8);
  expectAsUninterrupted();
  EXPECT_FALSE(render({}).wasDone) << "nothing unfinished is left to be asked about";
}

TEST_F(Resume, TakesAwayWhatWasKilledBeforeItsFirstFrame) {
  const fs::path begun = folder_ / "small.partial";
  fs::create_directories(begun);
  // Of a process of this machine that has ended
  std::string left = system::temporaryNameFor(begun / "scene.toml");
  std::ofstream(left.replace(left.rfind('-'), std::string::npos, "-99999999"));
  testing::render(smallScene(),
                  {.folder = folder_, .outputs = {pngOutput()}, .frames = store::FrameRange{3, 8}});
  render(kResume);
  expectAsUninterrupted();
  EXPECT_FALSE(fs::exists(begun));
}

TEST_F(Resume, LosesNoPartsUnasked) {
  testing::render(smallScene(),
                  {.folder = folder_, .outputs = {pngOutput()}, .frames = store::FrameRange{0, 5}});
  const std::string held =
      (folder_ / "small").string() + " holds 5 frames of a render that wasn't finished";
  EXPECT_EQ(failureOf({}), held + ": go on with --resume, or render again with --overwrite");
  EXPECT_MESSAGE(failureOf(kResume, otherScene()));
  EXPECT_EQ(render(kResume).framesKept, 5) << "the refusals cost frames";
}

TEST_F(Resume, LosesNoPartsOfOtherSettingsThoughItHasFramesOfItsOwn) {
  stop(4);
  // As though the part had been drawn first: it is refused beside frames of other settings.
  const fs::path elsewhere = folder_.parent_path() / "elsewhere";
  testing::render(
      otherScene(),
      {.folder = elsewhere, .outputs = {pngOutput()}, .frames = store::FrameRange{0, 5}});
  fs::rename(elsewhere / "small", folder_ / "small");
  EXPECT_MESSAGE(failureOf(kResume));
  EXPECT_EQ(store::framesIn(folder_ / "small").size(), 5U);
  EXPECT_EQ(render(kResumeOrOverwrite).framesKept, 4);
  expectAsUninterrupted();
}

TEST_F(Resume, RefusesAClipOfOtherSettings) {
  render({});
  EXPECT_EQ(failureOf(kResume, otherScene()),
            (folder_ / "small").string() +
                " holds the frames of a clip with other settings: body.mass is 1.0 there, 2.0 "
                "here; render "
                "again with --overwrite, or into another folder with -o");
  EXPECT_TRUE(render(kResume).wasDone) << "the refusal cost the clip";
  EXPECT_EQ(render(kResumeOrOverwrite, otherScene()).framesKept, 0);
}

TEST_F(Resume, OfARenderWhoseFrameWasRemovedDrawsItAgain) {
  const fs::path victim = folder_ / "small.partial" / store::frameName(0);
  const RenderListener listener{{}, [&](RenderProgress) { fs::remove(victim); }};
  const std::string message = messageOf<MachineError>([&] {
    renderClip(smallScene(), timeline::simulateScene(smallScene()), pngAndMp4(folder_), listener);
  });
  EXPECT_MESSAGE(message);
  EXPECT_EQ(render(kResume).framesKept, 11);
  expectAsUninterrupted();
}

TEST_F(Resume, OfARenderWhoseFrameWasChangedDrawsItAgain) {
  const fs::path victim = folder_ / "small.partial" / store::frameName(0);
  const RenderListener listener{
      {}, [&](RenderProgress) { fs::exists(victim) ? fs::resize_file(victim, 0) : void(); }};
  const std::string message = messageOf<MachineError>([&] {
    renderClip(smallScene(), timeline::simulateScene(smallScene()), pngAndMp4(folder_), listener);
  });
  EXPECT_MESSAGE(message);
  EXPECT_EQ(render(kResume).framesKept, 11);
  expectAsUninterrupted();
}

// Nobody else's frames are removed, nor those of which nothing is known any more.
TEST_F(Resume, AloneKeepsFramesOfADamagedManifest) {
  testing::render(otherScene(), pngAndMp4(folder_, {}, store::FrameRange{0, 5}));
  const fs::path manifest = folder_ / "small" / store::kManifestName;
  const std::string whole = bytesOf(manifest);
  for (const std::string& text : {std::string(), whole.substr(0, 300), std::string("\x01\xff[")}) {
    std::ofstream(manifest) << text;
    EXPECT_MESSAGE(failureOf({}));
    EXPECT_EQ(store::framesIn(folder_ / "small").size(), 5U);
    const RenderResult gif = testing::render(
        smallScene(), {.folder = folder_, .outputs = outputsOf(false, {video::VideoFormat::Gif})});
    EXPECT_THAT(gif.others, Contains(HasSubstr("(with unknown settings)")));
    EXPECT_EQ(store::framesIn(folder_ / "small").size(), 5U);
  }
  EXPECT_EQ(render(kOverwrite).framesKept, 0);
}

TEST_F(Resume, KeepsARecordThatNoRenderLeft) {
  for (const char* name : {"small", "small.partial", "small.replaced"}) {
    const fs::path record = folder_ / name / store::kSceneCopyName;
    fs::create_directories(record.parent_path());
    std::ofstream(record) << "title = \"mine\"\n";
    for (const bool png : {true, false}) {
      RenderOptions options = pngAndMp4(folder_);
      if (!png) options.outputs = outputsOf(false, {video::VideoFormat::Mp4});
      EXPECT_MESSAGE(messageOf<InputError>([&] { testing::render(smallScene(), options); }));
    }
    EXPECT_EQ(bytesOf(record), "title = \"mine\"\n");
    fs::remove_all(record.parent_path());
  }
}

TEST_F(Resume, IsNotProposedWhereTheFolderWasEmptied) {
  const fs::path begun = folder_ / "small.partial";
  const RenderListener listener{{}, [&](RenderProgress) {
                                  fs::remove(begun / store::frameName(0));
                                  fs::remove(begun / store::kManifestName);
                                }};
  const std::string message = messageOf<MachineError>([&] {
    renderClip(smallScene(), timeline::simulateScene(smallScene()), pngAndMp4(folder_), listener);
  });
  EXPECT_EQ(message, (begun / store::frameName(0)).string() +
                         " is gone: it was removed while the clip was rendered");
}

TEST_F(Resume, RefusesFramesOfOtherSettings) {
  stop(5);
  EXPECT_EQ(
      failureOf(kResume, otherScene()),
      (folder_ / "small.partial").string() +
          " holds 5 frames of a render that wasn't finished and had other settings: body.mass "
          "is 1.0 there, 2.0 here; render again with --overwrite, or into another folder with "
          "-o");
  EXPECT_EQ(render(kResume).framesKept, 5) << "the refusal cost frames";
}

TEST_F(Resume, RefusesFramesOfSettingsThatNothingStates) {
  stop(5);
  fs::remove(folder_ / "small.partial" / store::kManifestName);
  EXPECT_MESSAGE(failureOf(kResume));
}

TEST_F(Resume, IsAskedForWhereThereAreUnfinishedFrames) {
  stop(5);
  EXPECT_EQ(failureOf({}), (folder_ / "small.partial").string() +
                               " holds 5 frames of a render that wasn't finished: go on with "
                               "--resume, or render again with --overwrite");
  EXPECT_EQ(render(kOverwrite).framesKept, 0);
  expectAsUninterrupted();
}

TEST_F(Resume, OverwritesOnlyOtherSettingsIfBothAreAskedFor) {
  stop(5);
  stop(7, kResumeOrOverwrite);
  EXPECT_EQ(render(kResumeOrOverwrite, otherScene()).framesKept, 0);
  expectAsUninterrupted(pngAndMp4({}), otherScene());
}

TEST_F(Resume, LeavesAnUnfinishedRenderOfOtherSettingsAloneWhereItsOwnIsDone) {
  render({});
  stop(5, {}, otherScene());
  EXPECT_TRUE(render(kResume).wasDone);
  EXPECT_EQ(render(kResume, otherScene()).framesKept, 5);
  expectAsUninterrupted(pngAndMp4({}), otherScene());
}

// Leaves the files of a kill between any two steps of finishing.
class KilledWhileFinishing : public Resume {
 protected:
  /// A finished render of otherScene() lies in small/, and one of smallScene() that lacks but the
  /// last step in small.partial/.
  KilledWhileFinishing() {
    testing::render(smallScene(), pngAndMp4(folder_));
    fs::rename(final_, folder_ / "new");
    testing::render(otherScene(),
                    {.folder = folder_, .outputs = outputsOf(true, {video::VideoFormat::Gif})});
    std::ofstream(final_ / "notes.txt") << "a user's";
    fs::rename(folder_ / "new", folder_ / "small.partial");
  }

  /// The new clip is there, and the user's file, and of the old one the video of another format.
  void expectSettled(const store::EarlierFrames& earlier) {
    testing::render(smallScene(), pngAndMp4(folder_, earlier));
    EXPECT_EQ(bytesOf(final_ / "notes.txt"), "a user's");
    fs::remove(final_ / "notes.txt");
    EXPECT_TRUE(fs::remove(folder_ / "small.gif"));
    expectAsUninterrupted();
  }

  const fs::path final_ = folder_ / "small";
  const fs::path replaced_ = folder_ / "small.replaced";
};

TEST_F(KilledWhileFinishing, BeforeTheOldFolderIsMoved) {
  expectSettled(kResume);
}

TEST_F(KilledWhileFinishing, BeforeTheNewFolderIsMoved) {
  fs::rename(final_, replaced_);
  expectSettled(kResume);
}

TEST_F(KilledWhileFinishing, BeforeTheOldFolderIsRemoved) {
  fs::rename(final_, replaced_);
  fs::rename(folder_ / "small.partial", final_);
  expectSettled(kResume);
}

TEST_F(KilledWhileFinishing, WhileTheOldFolderIsRemoved) {
  fs::rename(final_, replaced_);
  fs::rename(folder_ / "small.partial", final_);
  fs::remove(replaced_ / store::kManifestName);
  fs::remove(replaced_ / store::frameName(0));
  expectSettled({});
}

TEST_F(KilledWhileFinishing, GivesTheOldFolderBackWhereThereIsNoNewOne) {
  fs::remove_all(folder_ / "small.partial");
  fs::rename(final_, replaced_);
  stop(2);
  EXPECT_TRUE(fs::exists(final_ / store::frameName(0)));
  EXPECT_FALSE(fs::exists(replaced_));
}

TEST_F(Resume, IsRefusedWhereAnotherProcessRenders) {
  fs::create_directories(folder_);
  const system::AdvisoryLock other(folder_ / "small", system::Lock::Exclusive);
  EXPECT_EQ(messageOf<MachineError>([&] { render(kResume); }),
            "another process is writing " + (folder_ / "small").string() + "; wait for it to end");
  EXPECT_THAT(namesIn(folder_), ElementsAre(".small.rotatebook-0"));
}

TEST_F(Resume, IsWhatAFailedRenderReports) {
  const RenderListener listener{
      [&](const RenderStart&) {
        fs::create_directories(folder_ / "small.partial" / store::frameName(9) / "in the way");
      },
      {}};
  const auto fail = [&] {
    renderClip(smallScene(), timeline::simulateScene(smallScene()),
               {.folder = folder_, .outputs = {pngOutput(1), videoOutput(video::VideoFormat::Mp4)}},
               listener);
  };
  const std::string partial = (folder_ / "small.partial").string();
  EXPECT_EQ(messageOf<MachineError>(fail),
            "can't write " + partial +
                "/frame_00009.png: it is a folder\n  10 finished frames are "
                "kept in " +
                partial + "/; go on with the same command and --resume");
  fs::remove_all(folder_ / "small.partial" / store::frameName(9));
  EXPECT_EQ(render(kResume).framesKept, 9);
  expectAsUninterrupted();
}

}  // namespace
}  // namespace rotatebook::pipeline
