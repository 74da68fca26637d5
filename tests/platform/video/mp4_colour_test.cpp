#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "video/bt709.h"
#include "video/decoded_video.h"
#include "video/test_clip.h"
#include "video/video_writer.h"

namespace rotatebook::video {
namespace {

using image::Image;
using image::PixelFormat;
using testing::Colour;
using testing::DecodedFrame;
using testing::DecodedVideo;
using testing::decodeVideo;
using testing::Matrix;

constexpr int kPatch = 48;  // [pixels]

constexpr std::array<Colour, 6> kChart = {
    {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {128, 128, 128}, {255, 255, 255}, {0, 0, 0}}};

// Errors of a flat patch after the encoder, of 255.
constexpr double kYuvBound = 1;      // measured 0.44
constexpr double kRgbBound = 2.5;    // measured 1.14
constexpr double kWrongMatrix = 20;  // measured 44.4 where BT.601 is assumed

Image chart() {
  Image picture(kPatch * static_cast<int>(kChart.size()), kPatch, PixelFormat::Rgb8);
  for (int y = 0; y < picture.height(); ++y) {
    for (int i = 0; i < picture.stride(); ++i) {
      const auto patch = static_cast<std::size_t>(i / 3 / kPatch);
      picture.row(y)[i] = static_cast<std::uint8_t>(kChart[patch][static_cast<std::size_t>(i % 3)]);
    }
  }
  return picture;
}

DecodedVideo decodedChart() {
  const Image picture = chart();
  VideoSettings settings;
  settings.width = picture.width();
  settings.height = picture.height();
  const auto path = testing::outputFolder() / "chart.mp4";
  VideoWriter writer(VideoFormat::Mp4, path, settings);
  for (int n = 0; n < 3; ++n) writer.write(picture.view());
  writer.finish();
  return decodeVideo(path);
}

Colour middleOfPatch(const DecodedFrame& frame, std::size_t patch) {
  const int width = kPatch * static_cast<int>(kChart.size());
  const int x = kPatch * static_cast<int>(patch) + kPatch / 2;
  const int y = kPatch / 2;
  const auto luma = static_cast<std::size_t>(y * width + x);
  const auto colour = static_cast<std::size_t>(y / 2 * (width / 2) + x / 2);
  return {double(frame.y.at(luma)), double(frame.u.at(colour)), double(frame.v.at(colour))};
}

double distance(const Colour& a, const Colour& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

// Largest error of a patch's colour, if a player reads the video with `matrix`.
double rgbError(const DecodedVideo& video, Matrix matrix) {
  double largest = 0;
  for (const DecodedFrame& frame : video.frames) {
    for (std::size_t patch = 0; patch < kChart.size(); ++patch) {
      const Colour rgb = testing::rgbFromYuv(middleOfPatch(frame, patch), matrix);
      largest = std::max(largest, distance(rgb, kChart[patch]));
    }
  }
  return largest;
}

TEST(Mp4Colour, IsBt709InTheDecodedVideo) {
  const DecodedVideo video = decodedChart();
  ASSERT_EQ(video.frames.size(), 3U);
  double largest = 0;
  for (const DecodedFrame& frame : video.frames) {
    for (std::size_t patch = 0; patch < kChart.size(); ++patch) {
      const Colour exact = testing::yuvFromRgb(kChart[patch]);
      largest = std::max(largest, distance(middleOfPatch(frame, patch), exact));
    }
  }
  RecordProperty("largest", std::to_string(largest));
  EXPECT_LT(largest, kYuvBound);
}

TEST(Mp4Colour, ComesBackAsTheChartWithBt709Only) {
  const DecodedVideo video = decodedChart();
  const double right = rgbError(video, testing::kBt709);
  const double wrong = rgbError(video, testing::kBt601);
  RecordProperty("right", std::to_string(right));
  RecordProperty("wrong", std::to_string(wrong));
  EXPECT_LT(right, kRgbBound);
  EXPECT_GT(wrong, kWrongMatrix);
}

TEST(Mp4Colour, FormulaKnowsTheColoursOfTheStandard) {
  EXPECT_NEAR(testing::yuvFromRgb({255, 255, 255})[0], 235, 1e-9);
  EXPECT_NEAR(testing::yuvFromRgb({0, 0, 0})[0], 16, 1e-9);
  EXPECT_NEAR(testing::yuvFromRgb({255, 0, 0})[0], 62.56, 0.005);
  EXPECT_NEAR(testing::yuvFromRgb({255, 0, 0})[2], 240, 1e-9);
  EXPECT_NEAR(testing::yuvFromRgb({0, 0, 255})[1], 240, 1e-9);
  EXPECT_NEAR(testing::yuvFromRgb({255, 0, 0}, testing::kBt601)[0], 81.48, 0.005);
}

}  // namespace
}  // namespace rotatebook::video
