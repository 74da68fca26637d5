// Small clips for the tests of this room.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>

#include "image/image.h"
#include "video/video_writer.h"

namespace rotatebook::video::testing {

inline constexpr int kWidth = 96;
inline constexpr int kHeight = 64;

inline VideoSettings smallSettings() {
  VideoSettings settings;
  settings.width = kWidth;
  settings.height = kHeight;
  return settings;
}

/// Returns the folder that the tests of this room write to; exists.
inline std::filesystem::path outputFolder() {
  const auto folder = std::filesystem::path(ROTATEBOOK_TEST_OUTPUT) / "video";
  std::filesystem::create_directories(folder);
  return folder;
}

/// Picture `n` of a clip: a white bar as far from the left as n says, on grey with a fixed texture.
inline image::Image barPicture(int n) {
  image::Image picture(kWidth, kHeight, image::PixelFormat::Rgba8);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool inBar = x >= 4 * n && x < 4 * n + 4;
      const int value = inBar ? 255 : 60 + (x * 7 + y * 13) % 32;
      std::fill_n(picture.row(y) + 4 * x, 4, static_cast<std::uint8_t>(value));
    }
  }
  return picture;
}

/// Writes `count` pictures (at most 24) and finishes.
inline void writeClip(const std::filesystem::path& path, const VideoSettings& settings, int count,
                      VideoFormat format = VideoFormat::Mp4) {
  VideoWriter writer(format, path, settings);
  for (int n = 0; n < count; ++n) writer.write(barPicture(n).view());
  writer.finish();
}

}  // namespace rotatebook::video::testing
