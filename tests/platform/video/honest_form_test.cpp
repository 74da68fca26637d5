// Files of other presets and sizes have the form that is asked for, too.
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "image/image.h"
#include "video/test_clip.h"
#include "video/written_form.h"

namespace rotatebook::video {
namespace {

WrittenForm honestForm(const VideoSettings& settings, int pictures) {
  return {.width = settings.width,
          .height = settings.height,
          .frameRate = settings.frameRate,
          .frames = pictures,
          .crf = settings.crf,
          .preset = settings.preset};
}

/// Writes pictures of noise; returns what differs in the file from what is written so.
FormDifferences differencesOfNoise(VideoFormat format, const VideoSettings& settings,
                                   int pictures) {
  const auto path = testing::outputFolder() / ("noise." + std::string(nameOf(format)));
  VideoWriter writer(format, path, settings);
  image::Image picture(settings.width, settings.height, image::PixelFormat::Rgba8);
  std::minstd_rand random(1);
  const auto byte = [&] { return static_cast<std::uint8_t>(random() >> 8); };
  for (int n = 0; n < pictures; ++n) {
    for (int y = 0; y < settings.height; ++y) {
      std::generate_n(picture.row(y), 4 * settings.width, byte);
    }
    writer.write(picture.view());
  }
  writer.finish();
  return differencesFromWritten(path, honestForm(settings, pictures));
}

VideoSettings settingsOf(int width, int height, int rate, int crf) {
  VideoSettings settings;
  settings.width = width;
  settings.height = height;
  settings.frameRate = {rate, 1};
  settings.crf = crf;
  settings.comment = "# a record";
  return settings;
}

/// Returns settings of other clips than those: of another rate factor, and of other presets.
std::vector<VideoSettings> othersThan(const VideoSettings& settings) {
  std::vector<VideoSettings> others{settings};
  others.back().crf = settings.crf + 1;
  for (const std::string_view preset : kVideoPresets) {
    if (preset == settings.preset) continue;
    others.push_back(settings);
    others.back().preset = preset;
  }
  return others;
}

// Each has parameters and an order of its own.
TEST(HonestForm, IsThatOfEachPreset) {
  constexpr int kMany = 50;
  for (const std::string_view preset : kVideoPresets) {
    for (const double interval : {0.02, 0.05, 0.4, 2.0}) {
      VideoSettings settings = settingsOf(testing::kWidth, testing::kHeight, 60, 20);
      settings.preset = preset;
      settings.keyFrameInterval = interval;
      const auto path = testing::outputFolder() / "preset.mp4";
      VideoWriter writer(VideoFormat::Mp4, path, settings);
      for (int n = 0; n < kMany; ++n) writer.write(testing::barPicture(n * n % 24).view());
      writer.finish();
      const FormDifferences found = differencesFromWritten(path, honestForm(settings, kMany));
      EXPECT_EQ(found.container + found.stream, "") << preset << " " << interval;
      for (const VideoSettings& other : othersThan(settings)) {
        const FormDifferences difference = differencesFromWritten(path, honestForm(other, kMany));
        EXPECT_EQ(difference.stream.empty(), preset == kWebPreset)
            << preset << " " << other.preset << " " << other.crf;
      }
    }
  }
}

// Parameters follow from the level, too, and it from size and rate.
TEST(HonestForm, IsThatOfEachSize) {
  std::vector<VideoSettings> all;
  using Case = std::array<int, 3>;
  for (const auto& [width, height, rate] :
       {Case{16, 16, 1}, Case{320, 180, 60}, Case{640, 360, 120}, Case{1280, 720, 240},
        Case{1920, 1080, 60}, Case{1080, 1920, 24}}) {
    all.push_back(settingsOf(width, height, rate, 40));
  }
  for (const VideoSettings& settings : all) {
    const FormDifferences found = differencesOfNoise(VideoFormat::Mp4, settings, 3);
    EXPECT_EQ(found.container + found.stream, "") << settings.width;
  }
}

// The muxers divide them.
TEST(HonestForm, IsThatOfFilesOfMegabytes) {
  for (const VideoFormat format : {VideoFormat::Mp4, VideoFormat::WebM}) {
    const FormDifferences found = differencesOfNoise(format, settingsOf(640, 360, 2, 1), 14);
    EXPECT_EQ(found.container + found.stream, "");
  }
  EXPECT_GT(std::filesystem::file_size(testing::outputFolder() / "noise.mp4"), 3'000'000U);
}

}  // namespace
}  // namespace rotatebook::video
