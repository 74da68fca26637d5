// The finished file's statements about itself.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "video/decoded_video.h"
#include "video/test_clip.h"
#include "video/video_writer.h"

namespace rotatebook::video {
namespace {

using testing::boxContent;
using testing::contentOf;
using testing::DecodedVideo;
using testing::decodeVideo;
using ::testing::ElementsAre;
using testing::kHeight;
using testing::kWidth;
using testing::outputFolder;
using testing::smallSettings;
using testing::writeClip;

TEST(Mp4File, IsWhatPlayersExpect) {
  writeClip(outputFolder() / "tags.mp4", smallSettings(), 3);
  const DecodedVideo video = decodeVideo(outputFolder() / "tags.mp4");
  EXPECT_EQ(video.width, kWidth);
  EXPECT_EQ(video.height, kHeight);
  EXPECT_EQ(video.profile, "High");
  EXPECT_EQ(video.pixelFormat, "yuv420p");
  EXPECT_EQ(video.codecTag, "avc1");
}

TEST(Mp4File, IsHighProfileWithEveryPreset) {
  std::set<std::uintmax_t> sizes;
  for (const char* preset : {"book", "ultrafast", "veryfast", "slow"}) {
    VideoSettings settings = smallSettings();
    settings.preset = preset;
    writeClip(outputFolder() / "preset.mp4", settings, 3);
    EXPECT_EQ(decodeVideo(outputFolder() / "preset.mp4").profile, "High") << preset;
    sizes.insert(std::filesystem::file_size(outputFolder() / "preset.mp4"));
  }
  EXPECT_EQ(sizes.size(), 4U) << "the preset changes nothing";
}

TEST(Mp4File, TagsItsColours) {
  writeClip(outputFolder() / "colours.mp4", smallSettings(), 1);
  const DecodedVideo video = decodeVideo(outputFolder() / "colours.mp4");
  EXPECT_EQ(video.primaries, "bt709");
  EXPECT_EQ(video.transfer, "bt709");
  EXPECT_EQ(video.matrix, "bt709");
  EXPECT_EQ(video.range, "tv");
  EXPECT_EQ(video.chromaLocation, "left");
  // In the container too: primaries, transfer and matrix 1, limited range.
  constexpr std::size_t kBeforeEntries = 8;  // version, flags, count
  constexpr std::size_t kBeforeBoxes = 78;   // the fixed part of a video entry
  const std::string stsd =
      boxContent(contentOf(outputFolder() / "colours.mp4"), "moov/trak/mdia/minf/stbl/stsd");
  const std::string avc1 = boxContent(stsd.substr(kBeforeEntries), "avc1");
  EXPECT_EQ(boxContent(avc1.substr(kBeforeBoxes), "colr"), std::string("nclx\0\1\0\1\0\1\0", 11));
}

TEST(Mp4File, HasItsIndexFirst) {
  writeClip(outputFolder() / "index.mp4", smallSettings(), 2);
  std::vector<std::string> types;
  for (const auto& box : testing::boxesIn(contentOf(outputFolder() / "index.mp4"))) {
    if (box.type != "free") types.push_back(box.type);
  }
  EXPECT_THAT(types, ElementsAre("ftyp", "moov", "mdat"));
}

struct Clock {
  FrameRate rate;
  int pictures;
};

class Mp4FileTime : public ::testing::TestWithParam<Clock> {
 protected:
  DecodedVideo decodedClip() const {
    VideoSettings settings = smallSettings();
    settings.frameRate = GetParam().rate;
    writeClip(path_, settings, GetParam().pictures);
    return decodeVideo(path_);
  }

  // The length of n frames, which must be whole. [ticks]
  std::int64_t ticks(std::int64_t n, std::int64_t timeScale) const {
    const std::int64_t product = n * GetParam().rate.denominator * timeScale;
    EXPECT_EQ(product % GetParam().rate.numerator, 0);
    return product / GetParam().rate.numerator;
  }

  // A single picture has none to be delayed by, and no box that says so. [ticks]
  std::uint32_t delayOfFirstPicture() const {
    if (GetParam().pictures == 1) return 0;
    const std::string offsets = boxContent(contentOf(path_), "moov/trak/mdia/minf/stbl/ctts");
    return testing::bigEndian(offsets, 12);
  }

  const std::filesystem::path path_ = outputFolder() / "time.mp4";
};

TEST_P(Mp4FileTime, StampsPictureNWithN) {
  const DecodedVideo video = decodedClip();
  ASSERT_EQ(video.frames.size(), static_cast<std::size_t>(GetParam().pictures));
  for (std::size_t n = 0; n < video.frames.size(); ++n) {
    EXPECT_EQ(video.frames[n].pts, ticks(static_cast<std::int64_t>(n), video.timeScale));
  }
}

TEST_P(Mp4FileTime, KeepsThePicturesInOrder) {
  const DecodedVideo video = decodedClip();
  for (int n = 0; n < GetParam().pictures; ++n) {
    const auto& row = video.frames.at(static_cast<std::size_t>(n)).y;
    const auto brightest = std::max_element(row.begin(), row.begin() + kWidth);
    EXPECT_EQ((brightest - row.begin()) / 4, n);
  }
}

TEST_P(Mp4FileTime, LastsExactlyAsLongAsItsPictures) {
  const DecodedVideo video = decodedClip();
  const std::int64_t pictures = GetParam().pictures;
  EXPECT_EQ(video.startTime, 0);
  EXPECT_EQ(video.frameCount, pictures);
  EXPECT_EQ(video.duration, ticks(pictures, video.timeScale));
  EXPECT_EQ(video.containerDurationUs,
            std::llround(1e6 * static_cast<double>(pictures) * GetParam().rate.period()));
  const std::string head = boxContent(contentOf(path_), "moov/mvhd");
  constexpr std::size_t kTimeScaleAt = 12;  // behind version, flags and two clock times
  EXPECT_EQ(testing::bigEndian(head, kTimeScaleAt + 4),
            ticks(pictures, testing::bigEndian(head, kTimeScaleAt)));
}

// B-frames delay the first picture on the track's own clock; the edit list takes exactly that back.
TEST_P(Mp4FileTime, StartsItsEditListAtTheFirstPicture) {
  const DecodedVideo video = decodedClip();
  const std::string list = boxContent(contentOf(path_), "moov/trak/edts/elst");
  EXPECT_EQ(testing::bigEndian(list, 4), 1U);  // one edit: nothing is cut or inserted
  EXPECT_EQ(testing::bigEndian(list, 12), delayOfFirstPicture());
}

INSTANTIATE_TEST_SUITE_P(Rates, Mp4FileTime,
                         ::testing::Values(Clock{{60, 1}, 20}, Clock{{30000, 1001}, 20},
                                           Clock{{24, 1}, 7}, Clock{{12, 1}, 1}),
                         [](const auto& test) {
                           const FrameRate rate = test.param.rate;
                           return "Rate" + std::to_string(rate.numerator) + "Over" +
                                  std::to_string(rate.denominator);
                         });

TEST(Mp4File, HasAKeyFrameEveryTwoSeconds) {
  VideoSettings settings = smallSettings();
  settings.frameRate = {4, 1};
  writeClip(outputFolder() / "keys.mp4", settings, 20);
  const std::string keys =
      boxContent(contentOf(outputFolder() / "keys.mp4"), "moov/trak/mdia/minf/stbl/stss");
  ASSERT_EQ(testing::bigEndian(keys, 4), 3U);
  EXPECT_EQ(testing::bigEndian(keys, 8), 1U);  // counted from 1
  EXPECT_EQ(testing::bigEndian(keys, 12), 9U);
  EXPECT_EQ(testing::bigEndian(keys, 16), 17U);
}

TEST(Mp4File, KeepsTitleAndComment) {
  VideoSettings settings = smallSettings();
  settings.title = "Das Buch dreht sich · 本 📖; comment=x '`ls`' \"\\\n[STREAM]";
  settings.comment = "# scene\n" + std::string(5 * 1024, '=') + "\nspin = 2 # ω ≈ 2 π\n";
  writeClip(outputFolder() / "words.mp4", settings, 1);
  const DecodedVideo video = decodeVideo(outputFolder() / "words.mp4");
  EXPECT_EQ(video.metadata.at("title"), settings.title);
  EXPECT_EQ(video.metadata.at("comment"), settings.comment);
}

TEST(Mp4File, SaysNothingThatNobodyAskedFor) {
  writeClip(outputFolder() / "bare.mp4", smallSettings(), 1);
  const DecodedVideo video = decodeVideo(outputFolder() / "bare.mp4");
  for (const char* key : {"title", "comment", "encoder", "creation_time"}) {
    EXPECT_EQ(video.metadata.count(key), 0U) << key;
  }
  const std::string head = boxContent(contentOf(outputFolder() / "bare.mp4"), "moov/mvhd");
  EXPECT_EQ(head.substr(4, 8), std::string(8, '\0'));  // creation and modification time
}

TEST(Mp4File, HasTheSameBytesAgain) {
  writeClip(outputFolder() / "a.mp4", smallSettings(), 20);
  writeClip(outputFolder() / "b.mp4", smallSettings(), 20);
  EXPECT_EQ(contentOf(outputFolder() / "a.mp4"), contentOf(outputFolder() / "b.mp4"));
  VideoSettings finer = smallSettings();
  finer.crf = 10;
  writeClip(outputFolder() / "b.mp4", finer, 20);
  EXPECT_GT(contentOf(outputFolder() / "b.mp4").size(), contentOf(outputFolder() / "a.mp4").size());
}

}  // namespace
}  // namespace rotatebook::video
