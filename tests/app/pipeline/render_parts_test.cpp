// Some frames of a clip, and clips put together from parts.
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/same_bytes.h"
#include "messages.h"
#include "pipeline/assemble.h"
#include "pipeline/small_clip.h"
#include "system/temporary_files.h"
#include "video/decoded_video.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::bytesOf;
using ::testing::ElementsAre;
using testing::emptyFolder;
using ::testing::HasSubstr;
using testing::kFrames;
using testing::namesIn;
using ::testing::Not;
using testing::pngAndMp4;
using testing::smallScene;

TEST(RenderParts, HaveTheFramesAndAVideoOfTheirOwn) {
  const fs::path folder = emptyFolder();
  const RenderResult result =
      testing::render(smallScene(), pngAndMp4(folder, {}, store::FrameRange{3, 5}));
  EXPECT_EQ(result.framesWritten, 2);
  EXPECT_THAT(namesIn(folder),
              ElementsAre("small", "small.csv", "small.json", "small_00003-00005.mp4"));
  EXPECT_THAT(namesIn(folder / "small"),
              ElementsAre("frame_00003.png", "frame_00004.png", "frames.manifest", "frames.xxh128",
                          "scene.toml"));
  EXPECT_EQ(video::testing::decodeVideo(folder / "small_00003-00005.mp4").frames.size(), 2U);
}

/// Renders one part as on one machine of several.
RenderResult renderPart(const fs::path& folder, std::int64_t number, std::int64_t count,
                        const scene::Scene& scene = smallScene()) {
  return testing::render(
      scene, {.folder = folder, .outputs = {pngOutput()}, .part = store::ClipPart{number, count}});
}

TEST(RenderParts, OfSeveralMachinesHaveFramesAlone) {
  const fs::path folder = emptyFolder();
  EXPECT_EQ(renderPart(folder, 2, 3).framesWritten, 4);
  EXPECT_THAT(namesIn(folder), ElementsAre("small"));
  EXPECT_THAT(namesIn(folder / "small"),
              ElementsAre("frame_00004.png", "frame_00005.png", "frame_00006.png",
                          "frame_00007.png", store::partChecksumsName(system::processName()),
                          "frames.manifest", "scene.toml"));
}

TEST(RenderParts, OfSeveralMachinesJoinToTheWhole) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder / "whole"));
  for (const std::int64_t number : {3, 1, 2, 5, 4}) renderPart(folder / "parts", number, 5);
  fs::remove(folder / "parts/small" / store::frameName(6));
  RenderOptions join = pngAndMp4(folder / "parts", {.resume = true});
  const RenderResult joined = testing::render(smallScene(), join);
  EXPECT_EQ(joined.framesKept, kFrames - 1);
  for (const char* below : {"", "small"}) {
    EXPECT_EQ(namesIn(folder / "parts" / below), namesIn(folder / "whole" / below));
    for (const std::string& name : namesIn(folder / "whole" / below)) {
      if (fs::is_directory(folder / "whole" / below / name)) continue;
      EXPECT_TRUE(rotatebook::testing::sameBytes(bytesOf(folder / "parts" / below / name),
                                                 bytesOf(folder / "whole" / below / name)))
          << name;
    }
  }
}

TEST(RenderParts, OfWhichThereAreMoreThanFramesMayBeEmpty) {
  const fs::path folder = emptyFolder() / "out";
  std::int64_t written = 0;
  for (std::int64_t number = 1; number <= 15; ++number) {
    written += renderPart(folder, number, 15).framesWritten;
  }
  EXPECT_EQ(written, kFrames);
  EXPECT_EQ(renderPart(folder / "no", 1, 15).framesWritten, 0);
  EXPECT_FALSE(fs::exists(folder / "no"));
}

TEST(RenderParts, KnowHowLongADivergingClipIs) {
  const fs::path folder = emptyFolder();
  const scene::Scene scene = testing::divergingScene();
  const std::int64_t count = timeline::simulateScene(scene).frameCount();
  EXPECT_EQ(count, 29);
  EXPECT_EQ(scene.clip.frameCount(), 12);
  EXPECT_EQ(
      renderPart(folder, 1, 2, scene).framesWritten + renderPart(folder, 2, 2, scene).framesWritten,
      count);
}

// Whether it has died before its first frame, or is about to draw it on another machine.
TEST(RenderParts, RefuseToJoinAPartOfOtherSettingsThatHasBegun) {
  const fs::path folder = emptyFolder();
  renderPart(folder, 1, 3);
  for (std::int64_t frame = 0; frame < 4; ++frame)
    fs::remove(folder / "small" / store::frameName(frame));
  const std::string before = bytesOf(folder / "small/scene.toml");
  EXPECT_MESSAGE(testing::messageOf<InputError>(
      [&] { renderPart(folder, 2, 3, smallScene({"camera.field_of_view_deg=40"})); }));
  EXPECT_EQ(bytesOf(folder / "small/scene.toml"), before);
  EXPECT_EQ(renderPart(folder, 2, 3).framesWritten, 4);
}

TEST(RenderParts, AssembleToTheWholesBytes) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder / "whole"));
  const fs::path parts = folder / "parts";
  testing::render(smallScene(), pngAndMp4(parts, {}, store::FrameRange{5, 12}));
  testing::render(smallScene(),
                  {.folder = parts, .outputs = {pngOutput()}, .frames = store::FrameRange{0, 5}});
  const Assembled made = assemble(parts / "small", parts / "all.mp4", {}, {});
  EXPECT_EQ(made.frames, (store::FrameRange{0, kFrames}));
  EXPECT_FALSE(made.isPart());
  EXPECT_EQ(bytesOf(parts / "all.mp4"), bytesOf(folder / "whole/small.mp4"));
  for (std::int64_t frame = 0; frame < kFrames; ++frame) {
    const std::string name = store::frameName(frame);
    EXPECT_TRUE(rotatebook::testing::sameBytes(bytesOf(parts / "small" / name),
                                               bytesOf(folder / "whole/small" / name)))
        << name;
  }
  EXPECT_EQ(bytesOf(parts / "small/scene.toml"), bytesOf(folder / "whole/small/scene.toml"));
}

TEST(RenderParts, AssembleToTheirOwnBytes) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder, {}, store::FrameRange{3, 5}));
  const Assembled made = assemble(folder / "small", folder / "part.mp4", {}, {});
  EXPECT_EQ(made.frames, (store::FrameRange{3, 5}));
  EXPECT_EQ(made.sceneFrames, kFrames);
  EXPECT_TRUE(made.isPart());
  EXPECT_TRUE(rotatebook::testing::sameBytes(bytesOf(folder / "part.mp4"),
                                             bytesOf(folder / "small_00003-00005.mp4")));
}

TEST(RenderParts, RecordTheirFramesInTheVideoAlone) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder, {}, store::FrameRange{3, 5}));
  const auto video = video::testing::decodeVideo(folder / "small_00003-00005.mp4");
  EXPECT_THAT(video.metadata.at("comment"), HasSubstr("\n# Frames: 3:5\n\n"));
  EXPECT_THAT(bytesOf(folder / "small/scene.toml"), Not(HasSubstr("# Frames")));
}

TEST(RenderParts, LeaveTheWholesVideoAlone) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder));
  const std::string whole = bytesOf(folder / "small.mp4");
  testing::render(smallScene(), pngAndMp4(folder, {}, store::FrameRange{2, 4}));
  EXPECT_EQ(bytesOf(folder / "small.mp4"), whole);
  EXPECT_EQ(store::framesIn(folder / "small").size(), static_cast<std::size_t>(kFrames));
}

TEST(RenderParts, DrawnAgainOverTheWholeChangeNoChecksum) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder));
  const std::string sums = bytesOf(folder / "small" / store::kFrameChecksumsName);
  testing::render(smallScene(), pngAndMp4(folder, {}, store::FrameRange{2, 5}));
  EXPECT_EQ(bytesOf(folder / "small" / store::kFrameChecksumsName), sums);
}

TEST(RenderParts, RefuseToJoinFramesOfOtherSettings) {
  const fs::path folder = emptyFolder();
  testing::render(smallScene(), pngAndMp4(folder, {}, store::FrameRange{0, 5}));
  const std::string before = bytesOf(folder / "small" / store::frameName(3));
  const auto join = [&] {
    testing::render(smallScene({"camera.field_of_view_deg=40"}),
                    pngAndMp4(folder, {}, store::FrameRange{3, 12}));
  };
  EXPECT_MESSAGE(testing::messageOf<InputError>(join));
  EXPECT_EQ(bytesOf(folder / "small" / store::frameName(3)), before);
  EXPECT_FALSE(fs::exists(folder / "small" / store::frameName(7)));
}

TEST(RenderParts, RefuseToLieBesideUnfinishedFramesOfOtherSettings) {
  const fs::path folder = emptyFolder();
  testing::stoppedAfter(4, smallScene(), pngAndMp4(folder));
  const auto part = [&](const scene::Scene& scene) {
    testing::render(
        scene, {.folder = folder, .outputs = {pngOutput()}, .frames = store::FrameRange{3, 12}});
  };
  EXPECT_MESSAGE(
      testing::messageOf<InputError>([&] { part(smallScene({"camera.field_of_view_deg=40"})); }));
  EXPECT_FALSE(fs::exists(folder / "small"));
  testing::render(smallScene({"camera.field_of_view_deg=40"}),
                  {.folder = folder,
                   .outputs = outputsOf(false, {video::VideoFormat::Mp4}),
                   .frames = store::FrameRange{3, 12}});
  part(smallScene());
  EXPECT_EQ(store::framesIn(folder / "small").size(), 9U);
}

TEST(RenderParts, OfAClipMustBeInIt) {
  const fs::path folder = emptyFolder() / "out";
  const auto part = [&](store::FrameRange range) {
    return testing::messageOf<InputError>(
        [&] { testing::render(smallScene(), pngAndMp4(folder, {}, range)); });
  };
  EXPECT_EQ(part({5, 13}), "frames 5:13 don't exist; this clip has 0:12");
  EXPECT_EQ(part({-1, 4}), "frames -1:4 don't exist; this clip has 0:12");
  EXPECT_EQ(part({6, 6}), "frames 6:6 don't exist; this clip has 0:12");
  EXPECT_EQ(part({9, 3}), "frames 9:3 don't exist; this clip has 0:12");
  EXPECT_FALSE(fs::exists(folder));
}

TEST(RenderParts, EndASecondAfterTheMotionDiverges) {
  const timeline::ClipMotion motion = timeline::simulateScene(testing::divergingScene());
  const std::int64_t count = motion.frameCount();
  EXPECT_EQ(framesToRender(motion, {}), (store::FrameRange{0, count}));
  EXPECT_EQ(framesToRender(motion, store::FrameRange{1, count}), (store::FrameRange{1, count}));
  EXPECT_EQ(
      testing::messageOf<InputError>([&] {
        framesToRender(motion, store::FrameRange{0, count + 1});
      }),
      "frames 0:30 don't exist; this clip has 0:29, up to a second after its motion diverges");
}

}  // namespace
}  // namespace rotatebook::pipeline
