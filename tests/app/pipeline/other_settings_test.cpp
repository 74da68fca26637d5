// Renders of other settings: files that they leave alone, and report.
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/same_bytes.h"
#include "messages.h"
#include "pipeline/rendered_again.h"
#include "store/manifest.h"
#include "system/file_checksum.h"
#include "video/video_writer.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::bytesOf;
using ::testing::ElementsAre;
using testing::kFrames;
using testing::kResume;
using testing::messageOf;
using testing::otherScene;
using testing::smallScene;
using testing::stoppedAfter;

std::string replaced(std::string text, const std::string& old, const std::string& now) {
  const std::size_t place = text.find(old);
  EXPECT_NE(place, text.npos) << old;
  return text.replace(place, old.size(), now);
}

class OtherSettings : public testing::RenderedAgain {
 protected:
  RenderResult renderGif(const store::EarlierFrames& earlier = {}) {
    return renderVideo(video::VideoFormat::Gif, earlier, otherScene());
  }
  std::string path(const char* name) const { return (folder_ / name).string(); }
};

TEST_F(OtherSettings, RemoveNoVideoOfAnotherFormat) {
  render({});
  const std::string mp4 = bytesOf(folder_ / "small.mp4");
  const RenderResult result = testing::render(
      otherScene(), {.folder = folder_, .outputs = outputsOf(true, {video::VideoFormat::Gif})});
  EXPECT_TRUE(rotatebook::testing::sameBytes(bytesOf(folder_ / "small.mp4"), mp4));
  EXPECT_THAT(result.others, ElementsAre(path("small.mp4")));
  EXPECT_THAT(render({}).others, ElementsAre(path("small.gif")));
}

TEST_F(OtherSettings, WithoutPngsKeepTheFramesWithTheirRecords) {
  render({});
  const std::string record = bytesOf(folder_ / "small" / store::kSceneCopyName);
  EXPECT_THAT(renderGif().others,
              ElementsAre(path("small.mp4"), "12 frames in " + path("small") + "/"));
  EXPECT_EQ(store::framesIn(folder_ / "small").size(), 12U);
  EXPECT_EQ(bytesOf(folder_ / "small" / store::kSceneCopyName), record);
  EXPECT_FALSE(fs::exists(folder_ / "small.partial"));
}

TEST_F(OtherSettings, OfFfmpegAloneKeepTheFrames) {
  render({});
  const fs::path mp4 = folder_ / "small.mp4", manifest = folder_ / "small/frames.manifest";
  const std::string before = system::checksumOfFile(mp4), version = video::ffmpegVersion();
  // Another version of as many bytes
  const std::string other = replaced(bytesOf(mp4), "# FFmpeg: " + version,
                                     "# FFmpeg: " + std::string(version.size(), '0'));
  std::ofstream(mp4, std::ios::binary) << other;
  const std::string changed = replaced(bytesOf(manifest), before, system::checksumOfFile(mp4));
  std::ofstream(manifest) << changed;
  const RenderResult result = render(kResume);
  EXPECT_FALSE(result.wasDone);
  EXPECT_EQ(result.framesKept, kFrames);
  expectAsUninterrupted();
}

TEST_F(OtherSettings, AreEachDoneByTheirRecords) {
  render({});
  renderGif();
  EXPECT_TRUE(renderGif(kResume).wasDone);
  // Its table and poster have been replaced; its frames are there.
  const RenderResult again = render(kResume);
  EXPECT_FALSE(again.wasDone);
  EXPECT_EQ(again.framesKept, kFrames);
  EXPECT_THAT(again.others, ElementsAre(path("small.gif")));
  EXPECT_FALSE(renderGif(kResume).wasDone);
}

TEST_F(OtherSettings, AreNotGoneOnWithUnasked) {
  render({});
  EXPECT_MESSAGE(messageOf<InputError>([&] { renderGif(kResume); }));
}

TEST_F(OtherSettings, KeepFramesOfWhichNothingIsKnown) {
  render({});
  fs::remove(folder_ / "small" / store::kManifestName);
  for (int time = 0; time < 2; ++time) {
    EXPECT_THAT(renderGif().others,
                ElementsAre("12 frames in " + path("small") + "/ (with unknown settings)"));
    EXPECT_EQ(store::framesIn(folder_ / "small").size(), 12U);
  }
  EXPECT_MESSAGE(messageOf<InputError>([&] { render({}); }));
}

TEST_F(OtherSettings, CostNoUnfinishedFramesWhereVideosAloneGoOn) {
  render({}, otherScene());
  stop(5);
  const RenderOptions videos{.folder = folder_,
                             .outputs = outputsOf(false, {video::VideoFormat::Mp4}),
                             .earlier = kResume};
  testing::render(smallScene(), videos);
  EXPECT_EQ(store::framesIn(folder_ / "small").size(), 12U);
  EXPECT_EQ(store::framesIn(folder_ / "small.partial").size(), 5U);
  EXPECT_EQ(render({.resume = true, .overwrite = true}).framesKept, 5);
}

TEST_F(OtherSettings, AreNoMatterToVideosThatAreMadeBesideUnfinishedFrames) {
  stop(5);
  const RenderOptions videos{.folder = folder_,
                             .outputs = outputsOf(false, {video::VideoFormat::Mp4}),
                             .earlier = kResume};
  testing::render(smallScene(), videos);
  EXPECT_TRUE(store::framesIn(folder_ / "small").empty()) << "unfinished frames aren't a clip's";
  EXPECT_EQ(store::framesIn(folder_ / "small.partial").size(), 5U);
  EXPECT_TRUE(testing::render(smallScene(), videos).wasDone);
  EXPECT_EQ(render(kResume).framesKept, 5);
  expectAsUninterrupted();
}

TEST_F(OtherSettings, OfAPartForgetNoFile) {
  testing::render(otherScene(),
                  {.folder = folder_, .outputs = outputsOf(false, {video::VideoFormat::Mp4})});
  const RenderOptions part{
      .folder = folder_, .outputs = {pngOutput()}, .frames = store::FrameRange{0, 3}};
  EXPECT_THAT(testing::render(smallScene(), part).others,
              ElementsAre(path("small.mp4"), path("small.poster.png")))
      << "table and result were replaced";
}

TEST_F(OtherSettings, AreReportedWhereTheyAreReplaced) {
  EXPECT_TRUE(render({}).replaced.empty());
  EXPECT_TRUE(render({}).replaced.empty()) << "the same settings";
  // The poster is the same: it has no text.
  EXPECT_THAT(render({}, otherScene()).replaced,
              ElementsAre(path("small.csv"), path("small.json"), path("small.mp4"),
                          "12 frames in " + path("small") + "/"));
  EXPECT_TRUE(renderGif().replaced.empty());
  EXPECT_TRUE(render(kResume, otherScene()).replaced.empty());
  std::ofstream(folder_ / "small.webm") << "somebody's";
  RenderOptions options{.folder = folder_, .outputs = outputsOf(false, {video::VideoFormat::WebM})};
  EXPECT_MESSAGE(messageOf<InputError>([&] { testing::render(otherScene(), options); }));
  options.earlier.overwrite = true;
  const RenderResult webm = testing::render(otherScene(), options);
  EXPECT_THAT(webm.replaced, ElementsAre(path("small.webm") + " (with unknown settings)"));
}

TEST_F(OtherSettings, AreReportedWhereAPartReplacesThem) {
  const RenderOptions whole{.folder = folder_,
                            .outputs = outputsOf(false, {video::VideoFormat::Mp4})};
  RenderOptions part = whole;
  part.frames = store::FrameRange{0, 3};
  testing::render(smallScene(), whole);
  EXPECT_TRUE(testing::render(smallScene(), part).replaced.empty());
  EXPECT_THAT(testing::render(otherScene(), part).replaced,
              ElementsAre(path("small.csv"), path("small.json"),
                          path("small_00000-00003.mp4") + " (with unknown settings)"));
}

TEST_F(OtherSettings, LeaveTheTableOfAnotherClip) {
  const auto sceneNamed = [](const char* name, const std::string& panels) {
    return scene::parseScene(
        "[initial]\nangular_velocity = [5, 3, 1]\n[clip]\n"
        "size = [64, 36]\nduration = 0.1\n" +
            panels,
        name);
  };
  const scene::Scene alone = sceneNamed("s_exact.toml", "");
  const std::string panels =
      "[[panel]]\nlabel = \"Exact\"\nbody.mass = 2\n[[panel]]\nlabel = \"b\"\n";
  const scene::Scene both = sceneNamed("s.toml", panels);
  const RenderOptions options{.folder = folder_, .outputs = {pngOutput()}};
  testing::render(alone, options);
  const std::string table = bytesOf(folder_ / "s_exact.csv");
  EXPECT_MESSAGE(messageOf<InputError>([&] { testing::render(both, options); }));
  EXPECT_EQ(bytesOf(folder_ / "s_exact.csv"), table);
  EXPECT_FALSE(fs::exists(folder_ / "s.partial"));

  // It may be replaced on purpose; then it is the other's
  RenderOptions overwriting = options;
  overwriting.earlier.overwrite = true;
  testing::render(both, overwriting);
  EXPECT_NE(bytesOf(folder_ / "s_exact.csv"), table);
  testing::render(both, options);
  EXPECT_MESSAGE(messageOf<InputError>([&] { testing::render(alone, options); }));
}

TEST_F(OtherSettings, AreNoMatterInAFolderThatWasRenamed) {
  render({});
  fs::rename(folder_ / "small", folder_ / "kept");
  EXPECT_NO_THROW(render({}, otherScene()));
  EXPECT_EQ(store::framesIn(folder_ / "kept").size(), 12U);
}

TEST_F(OtherSettings, LeaveTheTableOfAPartOfAnotherClip) {
  const std::string motion =
      "[initial]\nangular_velocity = [5, 3, 1]\n[clip]\nsize = [64, 36]\nduration = 0.1\n";
  testing::render(scene::parseScene(motion, "s_b.toml"),
                  {.folder = folder_, .outputs = {pngOutput()}, .frames = store::FrameRange{0, 2}});
  const scene::Scene both =
      scene::parseScene(motion + "[[panel]]\nlabel = \"a\"\n[[panel]]\nlabel = \"b\"\n", "s.toml");
  EXPECT_MESSAGE(messageOf<InputError>(
      [&] { testing::render(both, {.folder = folder_, .outputs = {pngOutput()}}); }));
}

TEST_F(OtherSettings, AreReportedWhereAnInterruptedVideoIsRemoved) {
  const RenderOptions options{.folder = folder_,
                              .outputs = outputsOf(false, {video::VideoFormat::Mp4})};
  stoppedAfter(3, smallScene(), options);
  EXPECT_TRUE(testing::render(smallScene(), options).replaced.empty()) << "its own";
  stoppedAfter(3, smallScene(), options);
  const RenderResult other = testing::render(otherScene(), options);
  EXPECT_THAT(other.replaced, ::testing::Contains(path("small.partial.mp4")));
  EXPECT_FALSE(fs::exists(folder_ / "small.partial.mp4"));
  std::ofstream(folder_ / "small.partial.mp4") << "mine";
  EXPECT_THAT(testing::render(otherScene(), options).replaced,
              ElementsAre(path("small.partial.mp4") + " (with unknown settings)"));
}

TEST_F(OtherSettings, LeaveAnInterruptedVideoOfAnotherFormat) {
  stoppedAfter(3, smallScene(),
               {.folder = folder_, .outputs = outputsOf(false, {video::VideoFormat::Gif})});
  render({});
  EXPECT_TRUE(fs::exists(folder_ / "small.partial.gif"));
}

}  // namespace
}  // namespace rotatebook::pipeline
