// The plain video for other programs, read back by FFmpeg.
#include "video/y4m_stream.h"

#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "video/decoded_video.h"
#include "video/pixel_converter.h"
#include "video/test_clip.h"

namespace rotatebook::video {
namespace {

/// The samples of a plane, without padding.
std::vector<std::uint8_t> streamedPlane(const AVFrame& frame, int plane, int width, int height) {
  std::vector<std::uint8_t> samples;
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row = frame.data[plane] + y * frame.linesize[plane];
    samples.insert(samples.end(), row, row + width);
  }
  return samples;
}

TEST(Y4mStream, HasTheSamplesThatAnMp4IsEncodedFrom) {
  constexpr int kStreamed = 5;
  VideoSettings settings = testing::smallSettings();
  settings.frameRate = {30, 1};
  const auto path = testing::outputFolder() / "stream.y4m";
  {
    std::ofstream file(path, std::ios::binary);
    Y4mStream stream(settings);
    for (int n = 0; n < kStreamed; ++n) file << stream.next(testing::barPicture(n).view());
  }
  const auto decoded = testing::decodeVideo(path);
  EXPECT_EQ(decoded.width, testing::kWidth);
  EXPECT_EQ(decoded.height, testing::kHeight);
  EXPECT_EQ(decoded.pixelFormat, "yuv420p");
  EXPECT_EQ(decoded.range, "tv");
  EXPECT_EQ(decoded.chromaLocation, "left");
  EXPECT_EQ(decoded.timeScale, 30);
  ASSERT_EQ(decoded.frames.size(), std::size_t{kStreamed});
  PixelConverter converter(testing::kWidth, testing::kHeight);
  for (int n = 0; n < kStreamed; ++n) {
    const AVFrame& wanted = converter.convert(testing::barPicture(n).view());
    const auto& frame = decoded.frames[static_cast<std::size_t>(n)];
    EXPECT_EQ(frame.y, streamedPlane(wanted, 0, testing::kWidth, testing::kHeight)) << n;
    EXPECT_EQ(frame.u, streamedPlane(wanted, 1, testing::kWidth / 2, testing::kHeight / 2)) << n;
    EXPECT_EQ(frame.v, streamedPlane(wanted, 2, testing::kWidth / 2, testing::kHeight / 2)) << n;
  }
}

TEST(Y4mStream, HasOneHeaderWithTheVeryRate) {
  VideoSettings settings = testing::smallSettings();
  settings.frameRate = {30000, 1001};
  Y4mStream stream(settings);
  EXPECT_TRUE(stream.next(testing::barPicture(0).view())
                  .starts_with("YUV4MPEG2 W96 H64 F30000:1001 Ip A1:1 C420mpeg2 "
                               "XYSCSS=420MPEG2 XCOLORRANGE=LIMITED\nFRAME\n"));
  EXPECT_TRUE(stream.next(testing::barPicture(1).view()).starts_with("FRAME\n"));
}

TEST(Y4mStream, RefusesOddSizesAndOtherPictures) {
  VideoSettings settings = testing::smallSettings();
  Y4mStream stream(settings);
  EXPECT_THROW(stream.next(image::Image(32, 32, image::PixelFormat::Rgb8).view()), InputError);
  ++settings.width;
  EXPECT_THROW(Y4mStream{settings}, InputError);
}

}  // namespace
}  // namespace rotatebook::video
