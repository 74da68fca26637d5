#include "video/mp4_chapters.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "video/decoded_video.h"
#include "video/test_clip.h"
#include "video/written_form.h"

namespace rotatebook::video {
namespace {

using ::testing::ElementsAre;

constexpr int kChaptered = 7;

VideoSettings settingsWith(std::vector<Chapter> chapters) {
  VideoSettings settings = testing::smallSettings();
  settings.comment = "# a record";
  settings.chapters = std::move(chapters);
  return settings;
}

std::string differenceFrom(const std::filesystem::path& path, const VideoSettings& settings) {
  return differencesFromWritten(path, {.width = testing::kWidth,
                                       .height = testing::kHeight,
                                       .frameRate = settings.frameRate,
                                       .frames = kChaptered,
                                       .crf = settings.crf,
                                       .preset = settings.preset,
                                       .chapters = settings.chapters})
      .container;
}

TEST(Mp4Chapters, AreReadByPlayers) {
  const auto path = testing::outputFolder() / "chapters.mp4";
  const auto plain = testing::outputFolder() / "chapterless.mp4";
  const VideoSettings settings = settingsWith({{0, "Start"}, {3, "Überschlag"}});
  testing::writeClip(path, settings, kChaptered);
  testing::writeClip(plain, settingsWith({}), kChaptered);
  const testing::DecodedVideo video = testing::decodeVideo(path);
  EXPECT_THAT(video.chapters, ElementsAre("0.00 Start", "0.05 Überschlag"));  // 3/60 s
  EXPECT_EQ(video.frames, testing::decodeVideo(plain).frames) << "no picture has moved";
  EXPECT_EQ(video.metadata.at("comment"), "# a record");
}

TEST(Mp4Chapters, AreOfTheFormThatIsWritten) {
  const auto path = testing::outputFolder() / "formed.mp4";
  const VideoSettings settings = settingsWith({{0, "Start"}, {3, "Flip"}});
  testing::writeClip(path, settings, kChaptered);
  EXPECT_EQ(differenceFrom(path, settings), "");
  EXPECT_EQ(differenceFrom(path, settingsWith({{0, "Start"}, {3, "Flop"}})),
            "moov/udta/chpl differs");
  EXPECT_EQ(differenceFrom(path, settingsWith({{0, "Start"}, {4, "Flip"}})),
            "moov/udta/chpl differs");
  EXPECT_EQ(differenceFrom(path, settingsWith({})), "moov/udta holds one chpl too many");
  testing::writeClip(path, settingsWith({}), kChaptered);
  EXPECT_EQ(differenceFrom(path, settings), "moov/udta lacks chpl");
}

TEST(Mp4Chapters, HaveNamesThatTheirLengthCounts) {
  std::string name;
  for (int i = 0; i < 200; ++i) name += "ü";
  const std::string list = chapterList(std::vector<Chapter>(300, {0, name}), {60, 1});
  EXPECT_EQ(list[8], '\xff');
  EXPECT_EQ(list.size(), 9U + 255 * (9 + 254));
}

TEST(WebmChapters, AreReadByPlayers) {
  const auto path = testing::outputFolder() / "chapters.webm";
  const auto plain = testing::outputFolder() / "chapterless.webm";
  testing::writeClip(path, settingsWith({{0, "Start"}, {3, "Überschlag"}}), kChaptered,
                     VideoFormat::WebM);
  testing::writeClip(plain, settingsWith({}), kChaptered, VideoFormat::WebM);
  const testing::DecodedVideo video = testing::decodeVideo(path);
  EXPECT_THAT(video.chapters, ElementsAre("0.00 Start", "0.05 Überschlag"));  // 3/60 s
  EXPECT_EQ(video.frames, testing::decodeVideo(plain).frames);
}

TEST(WebmChapters, AreOfTheFormThatIsWritten) {
  const auto path = testing::outputFolder() / "formed.webm";
  const VideoSettings settings = settingsWith({{0, "Start"}, {3, "Flip"}});
  testing::writeClip(path, settings, kChaptered, VideoFormat::WebM);
  EXPECT_EQ(differenceFrom(path, settings), "");
  for (const std::vector<Chapter>& other : {std::vector<Chapter>{{0, "Start"}, {3, "Flop"}},
                                            {{0, "Start"}, {4, "Flip"}},
                                            {{0, "Start"}},
                                            {{0, "Start"}, {3, "Flip"}, {4, "Flip"}}})
    EXPECT_EQ(differenceFrom(path, settingsWith(other)), "Segment/Chapters differs");
  EXPECT_EQ(differenceFrom(path, settingsWith({})), "Segment holds one Chapters too many");
  testing::writeClip(path, settingsWith({}), kChaptered, VideoFormat::WebM);
  EXPECT_EQ(differenceFrom(path, settings), "Segment/Chapters differs");
}

}  // namespace
}  // namespace rotatebook::video
