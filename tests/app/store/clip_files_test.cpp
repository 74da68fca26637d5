#include "store/clip_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "pipeline/small_clip.h"
#include "store/encoding.h"

namespace rotatebook::store {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(ClipFiles, NumberFramesWithFiveDigitsOrMore) {
  EXPECT_EQ(frameName(0), "frame_00000.png");
  EXPECT_EQ(frameName(42), "frame_00042.png");
  EXPECT_EQ(frameName(99999), "frame_99999.png");
  EXPECT_EQ(frameName(1234567), "frame_1234567.png");
}

TEST(ClipFiles, AreNamedAfterTheScene) {
  const ClipFiles files = clipFiles("out", "book");
  EXPECT_EQ(files.frameFolder, "out/book");
  EXPECT_EQ(files.sceneCopy, "out/book/scene.toml");
  EXPECT_EQ(files.video(video::VideoFormat::Mp4), "out/book.mp4");
  EXPECT_EQ(files.partialVideo(video::VideoFormat::Mp4), "out/book.partial.mp4");
  EXPECT_EQ(files.csv, "out/book.csv");
}

TEST(ClipFiles, OfPanelsKeepTheLettersOfLabels) {
  scene::Scene scene;
  scene.motions.clear();
  for (const char* label : {"Größtes Moment", "a/b: \u201cx\u201d \u2192 30\u00b0", "\u2192",
                            "漢字", "grÖßtes moment!"})
    scene.motions.emplace_back().label = label;
  EXPECT_THAT(csvFiles("out/book.csv", scene),
              ElementsAre("out/book_größtes-moment.csv", "out/book_a-b-x-30.csv", "out/book_3.csv",
                          "out/book_漢字.csv", "out/book_grÖßtes-moment.csv"));
}

TEST(ClipPart, IsCountedFromOne) {
  ASSERT_TRUE(parsePart("3/16"));
  EXPECT_EQ(parsePart("3/16")->number, 3);
  EXPECT_EQ(parsePart("3/16")->count, 16);
  EXPECT_TRUE(parsePart("1/1"));
  for (const char* text :
       {"", "3", "/3", "3/", "0/3", "4/3", "0/0", "-1/3", "1/3/5", "1 / 3", "1.0/3", "1/1000000"}) {
    EXPECT_FALSE(parsePart(text)) << text;
  }
}

TEST(ClipPart, HasEachFrameOnceWithTheOthers) {
  for (const std::int64_t frames : {1, 2, 12, 97, 216'000}) {
    for (const std::int64_t count :
         {std::int64_t{1}, std::int64_t{2}, std::int64_t{7}, kMaxParts}) {
      std::int64_t end = 0, least = frames, most = 0;
      for (std::int64_t number = 1; number <= count; ++number) {
        const FrameRange part = framesOf({number, count}, frames);
        ASSERT_EQ(part.first, end);
        end = part.end;
        least = std::min(least, part.count());
        most = std::max(most, part.count());
      }
      EXPECT_EQ(end, frames) << count;
      EXPECT_LE(most - least, 1) << count;
      EXPECT_EQ(least > 0, frames >= count);
    }
  }
}

TEST(ClipPart, LeavesFramesAlone) {
  const ClipFiles files = clipFiles("out", "book", ClipPart{2, 3});
  EXPECT_EQ(files.frameFolder, "out/book");
  EXPECT_THAT(outputFiles(files, scene::Scene(), {}), IsEmpty());
}

TEST(ClipFiles, OfAPartHaveAnMp4OfTheirOwn) {
  const ClipFiles files = clipFiles("out", "book", FrameRange{10, 20});
  EXPECT_EQ(files.frameFolder, "out/book");
  EXPECT_EQ(files.video(video::VideoFormat::Mp4), "out/book_00010-00020.mp4");
  EXPECT_EQ(files.partialVideo(video::VideoFormat::Mp4), "out/book_00010-00020.partial.mp4");
}

TEST(FrameRanges, AreWrittenAndRead) {
  EXPECT_EQ(rangeText({3, 12}), "3:12");
  EXPECT_EQ(parseRange("3:12"), (FrameRange{3, 12}));
  EXPECT_EQ(parseRange("12:3"), (FrameRange{12, 3}));
  for (const char* text :
       {"", "3", ":", "3:", ":3", "-1:3", "1:2:3", " 1:2", "1:2\n", "1:9999999999999"}) {
    EXPECT_FALSE(parseRange(text)) << text;
  }
}

TEST(FramesIn, AreFoundInOrderAmongForeignFiles) {
  const auto folder = pipeline::testing::emptyFolder();
  EXPECT_THAT(framesIn(folder), IsEmpty());
  for (const char* name :
       {"frame_00012.png", "frame_100000.png", "frame_00003.png", "scene.toml", "frame_0004.png",
        "frame_000005.png", "frame_-0001.png", "frame_00006.PNG", "frame_00007.png.tmp",
        "frame_+0008.png", "frame_.png", "frame_0000a.png", ".frame_00009.png.tmp-1",
        "xframe_00010.png", "frame_99999999999999999999.png"}) {
    std::ofstream(folder / name) << "x";
  }
  EXPECT_THAT(framesIn(folder), ElementsAre(3, 12, 100000));
}

TEST(FramesIn, NamesAFolderThatIsMissing) {
  const auto folder = pipeline::testing::emptyFolder() / "missing";
  EXPECT_MESSAGE(pipeline::testing::messageOf<InputError>([&] { framesIn(folder); }));
}

TEST(VideoSettings, AreTheScenes) {
  const scene::Scene scene = pipeline::testing::smallScene(
      {"clip.fps=\"30000/1001\"", "video.crf=30", "video.preset=slow", "video.threads=2"});
  const video::VideoSettings settings = videoSettings(scene, "the record");
  EXPECT_EQ(settings.width, 64);
  EXPECT_EQ(settings.height, 36);
  EXPECT_EQ(settings.frameRate, (FrameRate{30000, 1001}));
  EXPECT_EQ(settings.crf, 30);
  EXPECT_EQ(settings.preset, "slow");
  EXPECT_EQ(settings.threads, 2);
  EXPECT_EQ(settings.title, "Small · clip");
  EXPECT_EQ(settings.comment, "the record");
}

}  // namespace
}  // namespace rotatebook::store
