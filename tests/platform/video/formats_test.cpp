// All formats but MP4: what is read back is what was written.
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "messages.h"
#include "system/program_mark.h"
#include "video/clip_reader.h"
#include "video/decoded_pictures.h"
#include "video/decoded_video.h"
#include "video/test_clip.h"
#include "video/video_writer.h"

namespace rotatebook::video {
namespace {

namespace fs = std::filesystem;
using testing::contentOf;
using testing::DecodedPictures;
using testing::decodePictures;
using ::testing::HasSubstr;
using testing::kHeight;
using testing::kWidth;
using testing::outputFolder;
using testing::psnr;

constexpr int kPictures = 20;

/// Picture `n`: a disc that moves over a ground of colours; outside of the disc `alpha`.
image::Image discPicture(int n, std::uint8_t alpha = 255) {
  image::Image picture(kWidth, kHeight, image::PixelFormat::Rgba8);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      std::uint8_t* pixel = picture.row(y) + 4 * x;
      const bool inside = std::hypot(x - 20 - 2 * n, y - 30) < 16;
      pixel[0] = static_cast<std::uint8_t>(inside ? 200 : 40 + x);
      pixel[1] = static_cast<std::uint8_t>(inside ? 60 : 60 + y);
      pixel[2] = static_cast<std::uint8_t>(inside ? 40 : 110);
      pixel[3] = inside ? 255 : alpha;
    }
  }
  return picture;
}

VideoSettings settingsAt(FrameRate rate) {
  VideoSettings settings = testing::smallSettings();
  settings.frameRate = rate;
  return settings;
}

/// Writes kPictures pictures of the disc.
fs::path write(VideoFormat format, const VideoSettings& settings, const std::string& name,
               std::uint8_t alpha = 255) {
  const fs::path path = outputFolder() / (name + std::string(rowOf(format).ending));
  VideoWriter writer(format, path, settings);
  for (int n = 0; n < kPictures; ++n) writer.write(discPicture(n, alpha).view());
  writer.finish();
  return path;
}

/// The least likeness of a read picture to the one that was written. [dB]
double leastPsnr(const DecodedPictures& decoded, int every = 1, int shift = 0) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < decoded.pictures.size(); ++i) {
    const int n = every * static_cast<int>(i) + shift;
    least = std::min(least, psnr(decoded.pictures[i].picture, discPicture(n)));
  }
  return least;
}

TEST(WebM, HoldsEveryPictureAtItsTime) {
  constexpr double kAlike = 29.5;  // measured 31.1; 28.2 to the next picture
  const DecodedPictures decoded =
      decodePictures(write(VideoFormat::WebM, settingsAt({30, 1}), "times"));
  ASSERT_EQ(decoded.pictures.size(), kPictures);
  for (int n = 0; n < kPictures; ++n) {
    EXPECT_NEAR(decoded.pictures[static_cast<std::size_t>(n)].time, n / 30.0, 0.0006) << n;
  }
  EXPECT_NEAR(decoded.duration, kPictures / 30.0, 0.002);
  EXPECT_GT(leastPsnr(decoded), kAlike);
  EXPECT_LT(leastPsnr(decoded, 1, 1), kAlike);
}

TEST(Apng, HoldsTheVeryPixelsAtTheirTimes) {
  const DecodedPictures decoded =
      decodePictures(write(VideoFormat::Apng, settingsAt({30000, 1001}), "times"));
  ASSERT_EQ(decoded.pictures.size(), kPictures);
  for (int n = 0; n < kPictures; ++n) {
    const auto& [time, picture] = decoded.pictures[static_cast<std::size_t>(n)];
    EXPECT_NEAR(time, n * 1001 / 30000.0, 1e-4) << n;  // FFmpeg adds rounded times up
    EXPECT_EQ(picture, discPicture(n)) << n;
    EXPECT_NE(picture, discPicture(n + 1)) << n;
  }
}

TEST(Gif, HoldsEveryPictureInFewColours) {
  constexpr double kAlike = 40;  // measured 46.7; 25.8 to the next picture
  const DecodedPictures decoded =
      decodePictures(write(VideoFormat::Gif, settingsAt({50, 1}), "times"));
  ASSERT_EQ(decoded.pictures.size(), kPictures);
  for (int n = 0; n < kPictures; ++n) {
    EXPECT_NEAR(decoded.pictures[static_cast<std::size_t>(n)].time, n / 50.0, 1e-6) << n;
  }
  EXPECT_NEAR(decoded.duration, kPictures / 50.0, 0.011);
  EXPECT_GT(leastPsnr(decoded), kAlike);
  EXPECT_LT(leastPsnr(decoded, 1, 1), kAlike);
}

TEST(Gif, TakesEverySecondPictureOfAFastClip) {
  const DecodedPictures decoded =
      decodePictures(write(VideoFormat::Gif, settingsAt({60, 1}), "fast"));
  ASSERT_EQ(decoded.pictures.size(), kPictures / 2);
  for (std::size_t i = 0; i < decoded.pictures.size(); ++i) {
    EXPECT_NEAR(decoded.pictures[i].time, static_cast<double>(i) / 30, 0.0051) << i;
  }
  EXPECT_NEAR(decoded.duration, kPictures / 60.0, 0.011);
  constexpr double kAlike = 40;  // measured 46.7
  EXPECT_GT(leastPsnr(decoded, 2), kAlike);
  EXPECT_LT(leastPsnr(decoded, 1), kAlike);
}

/// Least likeness of all pictures, which must be at their times, and of each to the next one. [dB]
struct Likeness {
  double own = 0, next = 0;
};

Likeness likenessOf(VideoFormat format) {
  const DecodedPictures decoded = decodePictures(write(format, settingsAt({30000, 1001}), "times"));
  EXPECT_EQ(decoded.pictures.size(), kPictures);
  for (std::size_t n = 0; n < decoded.pictures.size(); ++n)
    EXPECT_NEAR(decoded.pictures[n].time, static_cast<double>(n) * 1001 / 30000, 1e-6) << n;
  EXPECT_NEAR(decoded.duration, kPictures * 1001 / 30000.0, 1e-6);
  return {leastPsnr(decoded), leastPsnr(decoded, 1, 1)};
}

TEST(EditorFormats, HoldEveryPictureAtItsTime) {
  const Likeness prores = likenessOf(VideoFormat::ProRes);
  EXPECT_GT(prores.own, 50);   // measured 58.0
  EXPECT_LT(prores.next, 35);  // measured 25.9
  const Likeness hevc = likenessOf(VideoFormat::Hevc);
  EXPECT_GT(hevc.own, 29.5);   // measured 30.8
  EXPECT_LT(hevc.next, 29.5);  // measured 28.2
  const Likeness av1 = likenessOf(VideoFormat::Av1);
  EXPECT_GT(av1.own, 29.5);   // measured 30.3
  EXPECT_LT(av1.next, 29.5);  // measured 26.9
}

TEST(EditorFormats, HoldNoRecordAndSaySo) {
  for (const auto& [format, title] : {std::pair(VideoFormat::ProRes, "prores"),
                                      {VideoFormat::Hevc, "hevc"},
                                      {VideoFormat::Av1, "av1"}}) {
    VideoSettings settings = settingsAt({30, 1});
    settings.comment = "a record";
    const fs::path path = write(format, settings, "record");
    EXPECT_EQ(contentOf(path).find("a record"), std::string::npos);
    EXPECT_TRUE(system::hasProgramMark(path));
    try {
      readClipMetadata(path);
      ADD_FAILURE() << title;
    } catch (const InputError& error) {
      EXPECT_MESSAGE(error.what());
    }
  }
}

TEST(EditorFormats, HaveTheSameBytesWhateverTheNumberOfThreads) {
  for (const VideoFormat format : {VideoFormat::ProRes, VideoFormat::Hevc, VideoFormat::Av1}) {
    VideoSettings settings = settingsAt({30, 1});
    settings.threads = 1;
    const std::string one = contentOf(write(format, settings, "one"));
    settings.threads = 3;
    EXPECT_EQ(one, contentOf(write(format, settings, "three"))) << nameOf(format);
  }
}

TEST(GifAndApng, LoopForEver) {
  EXPECT_THAT(contentOf(write(VideoFormat::Gif, settingsAt({50, 1}), "loops")),
              HasSubstr(std::string("NETSCAPE2.0\x03\x01\0\0", 15)));
  const std::string apng = contentOf(write(VideoFormat::Apng, settingsAt({50, 1}), "loops"));
  EXPECT_THAT(apng, HasSubstr(std::string("acTL\0\0\0\x14\0\0\0\0", 12)));
}

TEST(WebMApngAndProRes, KeepTransparency) {
  constexpr int kAlphaBound = 4;  // of 255; measured 0
  VideoSettings settings = settingsAt({30, 1});
  settings.transparent = true;
  for (const VideoFormat format : {VideoFormat::WebM, VideoFormat::Apng, VideoFormat::ProRes}) {
    const DecodedPictures decoded = decodePictures(write(format, settings, "transparent", 0));
    ASSERT_EQ(decoded.pictures.size(), kPictures) << nameOf(format);
    const image::Image& picture = decoded.pictures[5].picture;
    const auto alphaAt = [&](int x, int y) { return int{picture.row(y)[4 * x + 3]}; };
    EXPECT_GT(alphaAt(30, 30), 255 - kAlphaBound) << nameOf(format);
    EXPECT_LT(alphaAt(80, 30), kAlphaBound) << nameOf(format);
    EXPECT_LT(alphaAt(2, 60), kAlphaBound) << nameOf(format);
  }
}

TEST(WebMAndApng, AreOpaqueUnlessAsked) {
  for (const VideoFormat format : {VideoFormat::WebM, VideoFormat::Apng}) {
    const DecodedPictures decoded = decodePictures(write(format, settingsAt({30, 1}), "opaque", 0));
    EXPECT_EQ(decoded.pictures[5].picture.row(30)[4 * 80 + 3], 255) << nameOf(format);
  }
}

TEST(Formats, RefuseTransparencyThatTheyCanNotHold) {
  VideoSettings settings = settingsAt({30, 1});
  settings.transparent = true;
  for (const VideoFormat format :
       {VideoFormat::Mp4, VideoFormat::Gif, VideoFormat::Hevc, VideoFormat::Av1}) {
    try {
      write(format, settings, "refused");
      ADD_FAILURE() << nameOf(format);
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), std::string(nameOf(format)) +
                                  " can't hold a transparent picture; webm, apng and prores can");
    }
  }
}

TEST(Formats, GiveTheSameBytesEachTimeAndOthersForOtherPictures) {
  for (const VideoFormat format : kVideoFormats) {
    const std::string first = contentOf(write(format, settingsAt({30, 1}), "a"));
    EXPECT_EQ(first, contentOf(write(format, settingsAt({30, 1}), "b"))) << nameOf(format);
    EXPECT_NE(first, contentOf(write(format, settingsAt({25, 1}), "c"))) << nameOf(format);
  }
}

TEST(Formats, NameAFullDisk) {
  for (const VideoFormat format : kVideoFormats) {
    try {
      VideoWriter writer(format, "/dev/full", settingsAt({30, 1}));
      for (int n = 0; n < 3; ++n) writer.write(discPicture(n).view());
      writer.finish();
      ADD_FAILURE() << nameOf(format);
    } catch (const MachineError& error) {
      EXPECT_MESSAGE(error.what()) << nameOf(format);
    }
  }
}

TEST(Formats, RefuseAPictureOfAnotherSize) {
  for (const VideoFormat format : kVideoFormats) {
    VideoWriter writer(format, outputFolder() / "size", settingsAt({30, 1}));
    const image::Image wide(98, 64, image::PixelFormat::Rgba8);
    EXPECT_THROW(writer.write(wide.view()), InputError) << nameOf(format);
  }
}

}  // namespace
}  // namespace rotatebook::video
