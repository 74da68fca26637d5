// Clips read back by the program, beside what the tests' own decoder reads.
#include "video/clip_reader.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "video/decoded_video.h"
#include "video/forged_mp4.h"
#include "video/test_clip.h"

namespace rotatebook::video {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::barPicture;
using testing::contentOf;
using testing::DecodedVideo;
using ::testing::HasSubstr;
using testing::outputFolder;
using testing::smallSettings;
using ::testing::StartsWith;

constexpr int kCount = 7;

/// A clip of kCount pictures with metadata; returns its path.
fs::path writeAs(VideoFormat format, const std::string& name,
                 VideoSettings settings = smallSettings()) {
  settings.title = "A title";
  settings.comment = "# a comment\n\nof = 'lines · and more'\n";
  const fs::path path = outputFolder() / ("reader_" + name + "." + std::string(nameOf(format)));
  VideoWriter writer(format, path, settings);
  for (int n = 0; n < kCount; ++n) writer.write(barPicture(n).view());
  writer.finish();
  return path;
}

std::span<const std::uint8_t> bytesOf(const std::string& content) {
  return {reinterpret_cast<const std::uint8_t*>(content.data()), content.size()};
}

/// Returns the error of reading the metadata; "read" if there was none.
std::string outcomeOf(const std::string& content) {
  try {
    readClipMetadata(bytesOf(content), "the bytes");
    return "read";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Decodes all of a file; returns the number of pictures, or what was said.
std::string decodingOf(const fs::path& path) {
  try {
    ClipReader reader(path);
    int count = 0;
    while (reader.next()) ++count;
    return std::to_string(count);
  } catch (const InputError& error) {
    return error.what();
  }
}

bool sameValues(const std::vector<float>& a, const std::vector<std::uint8_t>& b) {
  return std::vector<float>(b.begin(), b.end()) == a;
}

TEST(ClipMetadata, ComesFromFilesAndFromMemory) {
  for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::WebM}) {
    const fs::path path = writeAs(format, "metadata");
    const std::string content = contentOf(path);
    for (const ClipMetadata& metadata :
         {readClipMetadata(path), readClipMetadata(bytesOf(content), "x")}) {
      EXPECT_EQ(metadata.format, format);
      EXPECT_EQ(metadata.title, "A title");
      EXPECT_EQ(metadata.comment, "# a comment\n\nof = 'lines · and more'\n");
    }
  }
}

TEST(ClipMetadata, MayBeLong) {
  VideoSettings settings = smallSettings();
  const fs::path path = outputFolder() / "reader_long.mp4";
  settings.comment = std::string(3'000'000, 'x');
  testing::writeClip(path, settings, 2);
  EXPECT_TRUE(readClipMetadata(path).comment == settings.comment);
}

TEST(ClipMetadata, IsInNeitherGifNorApng) {
  for (const VideoFormat format : {VideoFormat::Gif, VideoFormat::Apng}) {
    const std::string content = contentOf(writeAs(format, "none"));
    EXPECT_EQ(outcomeOf(content), "the bytes is in the format " + std::string(nameOf(format)) +
                                      ", which holds no record of the scene; MP4 and WebM do");
  }
}

TEST(PictureSizeOfAClip, IsKnownOfEachFormat) {
  for (const VideoFormat format :
       {VideoFormat::Mp4, VideoFormat::WebM, VideoFormat::Gif, VideoFormat::Apng}) {
    EXPECT_EQ(readPictureSize(writeAs(format, "size")),
              (PictureSize{testing::kWidth, testing::kHeight}))
        << nameOf(format);
  }
  EXPECT_THROW(readPictureSize("no such file.mp4"), InputError);
}

TEST(ClipMetadata, OfWhatIsNoVideoIsRefused) {
  for (const std::string& content :
       {std::string(), std::string("x"), std::string(100'000, '\0'), std::string(5000, '<'),
        std::string("#EXTM3U\nfile:///etc/passwd\n"),
        std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x8\6\0\0\0", 29),
        std::string("ffconcat version 1.0\nfile 'a'\n")}) {
    EXPECT_EQ(outcomeOf(content), "the bytes isn't an MP4 or WebM");
  }
  EXPECT_THROW(readClipMetadata("no such file.mp4"), InputError);
  EXPECT_THROW(readClipMetadata(outputFolder()), InputError);
}

TEST(ClipMetadata, OfADamagedWebmIsSaidToBeUnreadable) {
  const std::string content = contentOf(writeAs(VideoFormat::WebM, "head")).substr(0, 20);
  EXPECT_THAT(outcomeOf(content), StartsWith("can't read the bytes: "));
}

TEST(ClipMetadata, OfFilesCutOffAnywhereIsReadOrRefused) {
  for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::WebM}) {
    const std::string content = contentOf(writeAs(format, "cut"));
    int refused = 0;
    for (std::size_t size = 0; size < content.size(); size += 13) {
      refused += outcomeOf(content.substr(0, size)) == "read" ? 0 : 1;
    }
    EXPECT_GT(refused, 10);
  }
}

TEST(ClipMetadata, OfDamagedFilesIsReadOrRefused) {
  for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::WebM}) {
    const std::string content = contentOf(writeAs(format, "damaged"));
    for (std::size_t at = 0; at < content.size() && at < 1500; ++at) {
      for (const char value : {'\x00', '\x7f', '\xff'}) {
        std::string damaged = content;
        damaged[at] = value;
        outcomeOf(damaged);
      }
    }
  }
}

TEST(ClipMetadata, NeedsOneStreamOfPictures) {
  // The type of the track's handler: sound.
  const std::string content = contentOf(writeAs(VideoFormat::Mp4, "sound"));
  const std::size_t handler = content.find("vide");
  ASSERT_NE(handler, std::string::npos);
  std::string other = content;
  other.replace(handler, 4, "soun");
  EXPECT_EQ(outcomeOf(other),
            "the bytes has no video stream; a clip has exactly one stream, of video");
  // The track once more.
  const std::size_t movie = content.find("moov") - 4, track = content.find("trak") - 4;
  const std::string again = content.substr(track, testing::bigEndian(content, track));
  other = content;
  other.insert(track, again);
  const auto size = static_cast<std::uint32_t>(testing::bigEndian(content, movie) + again.size());
  for (std::size_t i = 0; i < 4; ++i) other[movie + i] = static_cast<char>(size >> (24 - 8 * i));
  EXPECT_EQ(outcomeOf(other), "the bytes has 2 streams; a clip has exactly one stream, of video");
}

TEST(ClipReader, ReportsWhatThePlayerReads) {
  const fs::path path = writeAs(VideoFormat::Mp4, "facts");
  const ClipFacts facts = ClipReader(path).facts();
  const DecodedVideo video = testing::decodeVideo(path);
  EXPECT_EQ(facts.format, VideoFormat::Mp4);
  EXPECT_EQ(facts.width, video.width);
  EXPECT_EQ(facts.height, video.height);
  EXPECT_EQ(facts.codec, "h264");
  EXPECT_EQ(facts.profile, video.profile);
  EXPECT_EQ(facts.pixelFormat, video.pixelFormat);
  EXPECT_EQ(facts.colours.primaries, video.primaries);
  EXPECT_EQ(facts.containerColours.primaries, video.primaries);
  EXPECT_EQ(facts.colours.transfer, video.transfer);
  EXPECT_EQ(facts.containerColours.transfer, video.transfer);
  EXPECT_EQ(facts.colours.matrix, video.matrix);
  EXPECT_EQ(facts.containerColours.matrix, video.matrix);
  EXPECT_EQ(facts.colours.range, video.range);
  EXPECT_EQ(facts.containerColours.range, video.range);
  EXPECT_NEAR(facts.duration, kCount / 60.0, 1e-6);
  EXPECT_EQ(facts.pixelShape, "1:1");
  EXPECT_EQ(facts.containerShape, "1:1");
  EXPECT_EQ(facts.display, "as stored");
}

TEST(ClipReader, ReportsWhatTheContainerSaysOtherwise) {
  const std::string content = contentOf(writeAs(VideoFormat::Mp4, "true"));
  const fs::path path = outputFolder() / "reader_forged.mp4";
  const auto factsOf = [&](const std::vector<testing::BoxPatch>& patches) {
    std::ofstream(path, std::ios::binary) << testing::forgedMp4(content, patches);
    return ClipReader(path).facts();
  };
  EXPECT_EQ(factsOf(testing::kTurned).display, "Display Matrix -1 0, 0 -1");
  EXPECT_EQ(factsOf(testing::kMirrored).display, "Display Matrix -1 0, 0 1");
  EXPECT_EQ(factsOf(testing::kWholeTurned).display, "Display Matrix -1 0, 0 -1");
  const ClipFacts wide = factsOf(testing::kWidePixels);
  EXPECT_EQ(wide.containerShape, "3:1");
  EXPECT_EQ(wide.pixelShape, "1:1");
  const ClipFacts coloured = factsOf(testing::kOtherColours);
  EXPECT_EQ(coloured.containerColours.primaries, "bt2020");
  EXPECT_EQ(coloured.containerColours.transfer, "smpte2084");
  EXPECT_EQ(coloured.containerColours.matrix, "bt2020nc");
  EXPECT_EQ(coloured.colours.primaries, "bt709");
  EXPECT_EQ(factsOf(testing::kFullRange).containerColours.range, "pc");
}

TEST(ClipReader, ReportsWhatAWebMSaysOtherwise) {
  const fs::path path = writeAs(VideoFormat::WebM, "shape");
  EXPECT_EQ(ClipReader(path).facts().containerShape, "1:1");
  EXPECT_EQ(ClipReader(path).facts().containerColours.primaries, "bt709");
  std::string content = contentOf(path);
  const std::size_t transfer = content.find("\x55\xba\x81");  // Of one byte.
  ASSERT_NE(transfer, std::string::npos);
  content[transfer + 3] = 16;
  std::ofstream(path, std::ios::binary) << content;
  EXPECT_EQ(ClipReader(path).facts().containerColours.transfer, "smpte2084");
}

TEST(ClipReader, DecodesThePicturesAndTimesOfTheYardstick) {
  VideoSettings settings = smallSettings();
  settings.frameRate = {30000, 1001};
  const fs::path path = writeAs(VideoFormat::Mp4, "pictures", settings);
  const DecodedVideo video = testing::decodeVideo(path);
  ClipReader reader(path);
  ASSERT_EQ(video.frames.size(), std::size_t{kCount});
  for (int n = 0; n < kCount; ++n) {
    ASSERT_TRUE(reader.next()) << n;
    const testing::DecodedFrame& frame = video.frames[static_cast<std::size_t>(n)];
    const Planes picture = reader.picture();
    EXPECT_TRUE(sameValues(picture.y, frame.y)) << n;
    EXPECT_TRUE(sameValues(picture.u, frame.u)) << n;
    EXPECT_TRUE(sameValues(picture.v, frame.v)) << n;
    EXPECT_TRUE(picture.alpha.empty()) << n;
    EXPECT_NEAR(reader.time(), n * 1001 / 30000.0, 1e-12) << n;
  }
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(reader.next());
}

TEST(ClipReader, DecodesAlpha) {
  VideoSettings settings = smallSettings();
  settings.transparent = true;
  const fs::path path = outputFolder() / "reader_alpha.webm";
  VideoWriter writer(VideoFormat::WebM, path, settings);
  const image::Image picture = barPicture(3);  // Its alpha is its grey.
  for (int n = 0; n < 2; ++n) writer.write(picture.view());
  writer.finish();
  ClipReader reader(path);
  ASSERT_TRUE(reader.next());
  const Planes planes = reader.picture();
  ASSERT_EQ(planes.alpha.size(), planes.y.size());
  constexpr double kAlike = 6;  // measured 2.2
  EXPECT_LT(distance(planes, planesOf(picture.view(), true)).rms, kAlike);
}

TEST(ClipReader, RefusesOrCountsTheTruncated) {
  const fs::path path = writeAs(VideoFormat::Mp4, "whole");
  const std::string content = contentOf(path);
  EXPECT_EQ(decodingOf(path), std::to_string(kCount));
  const fs::path cut = outputFolder() / "reader_cut.mp4";
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(content.size()));
    std::ofstream(cut, std::ios::binary) << content.substr(0, size);
    EXPECT_NE(decodingOf(cut), std::to_string(kCount)) << share;
  }
}

TEST(ClipReader, SurvivesDamage) {
  for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::WebM}) {
    const std::string content = contentOf(writeAs(format, "fuzzed"));
    const fs::path path = outputFolder() / ("reader_fuzz." + std::string(nameOf(format)));
    for (std::size_t at = 0; at < content.size(); at += 1 + content.size() / 150) {
      std::string damaged = content;
      damaged[at] = static_cast<char>(~damaged[at]);
      std::ofstream(path, std::ios::binary) << damaged;
      decodingOf(path);
    }
  }
}

// Both sides of the picture as the container has them, as large as they can be.
TEST(ClipReader, TakesNoMemoryForHugePictures) {
  std::string content = contentOf(writeAs(VideoFormat::Mp4, "huge"));
  const std::size_t entry = content.find("avc1", content.find("stsd"));
  ASSERT_NE(entry, std::string::npos);
  content.replace(entry + 28, 4, "\xff\xff\xff\xff");
  const fs::path path = outputFolder() / "reader_huge.mp4";
  std::ofstream(path, std::ios::binary) << content;
  EXPECT_NE(decodingOf(path), "");
}

}  // namespace
}  // namespace rotatebook::video
