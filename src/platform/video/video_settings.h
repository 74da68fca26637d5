// The settings of a video.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/clip_limits.h"
#include "base/frame_rate.h"

namespace rotatebook::video {

/// Smallest width and height of a video: one macroblock. [pixels]
inline constexpr int kSmallestSide = 16;

/// Preset of clips that are coded anew for the web, at a rate factor that their record doesn't
/// have.
inline constexpr std::string_view kWebPreset = "slow";

/// A chapter of a video.
struct Chapter {
  std::int64_t frame = 0;  ///< Its first.
  std::string name;        ///< UTF-8.

  friend bool operator==(const Chapter&, const Chapter&) = default;
};

/// Everything that the bytes of a video depend on beside its format and pictures.
struct VideoSettings {
  int width = 1280;  ///< At least kSmallestSide; even for MP4 and WebM. [pixels]
  int height = 720;  ///< Like `width`. [pixels]
  FrameRate frameRate;
  bool transparent = false;         ///< Keep the pictures' alpha; WebM, APNG and ProRes.
  int crf = 18;                     ///< MP4: x264's constant rate factor, kBestCrf to kWorstCrf.
  std::string preset{kBookPreset};  ///< MP4: one of kVideoPresets.
  int threads = 1;                  ///< MP4: encoder threads, >= 1. The bytes depend on it.
  /// MP4 and WebM: players start from a key frame, so it is what they decode to go to a moment. [s]
  double keyFrameInterval = 2;
  std::string title;  ///< Stored in the metadata of MP4 and WebM; UTF-8.
  /// Stored in the metadata of MP4 and WebM; UTF-8. rotatebook stores the resolved scene.
  std::string comment;
  std::vector<Chapter> chapters;  ///< MP4, its first kMostChapters; WebM. In their order.
};

}  // namespace rotatebook::video
