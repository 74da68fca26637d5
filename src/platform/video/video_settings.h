// What the bytes of a video depend on.
#pragma once

#include <string>

#include "base/clip_limits.h"
#include "base/frame_rate.h"

namespace rotatebook::video {

/// Narrowest and lowest video: one macroblock. [pixels]
inline constexpr int kSmallestSide = 16;

/// Everything that the bytes of a video depend on beside its format and pictures.
struct VideoSettings {
  int width = 1280;  ///< At least kSmallestSide; even for MP4 and WebM. [pixels]
  int height = 720;  ///< As `width`. [pixels]
  FrameRate frameRate;
  bool transparent = false;         ///< Keep the pictures' alpha; WebM and APNG only.
  int crf = 18;                     ///< MP4: x264's constant rate factor, kBestCrf to kWorstCrf.
  std::string preset{kBookPreset};  ///< MP4: One of kVideoPresets.
  int threads = 1;    ///< MP4: encoder threads, >= 1. Another count gives other bytes.
  std::string title;  ///< Stored in the metadata of MP4 and WebM; UTF-8.
  std::string
      comment;  ///< Stored in the metadata of MP4 and WebM; UTF-8. rotatebook: the resolved scene.
};

}  // namespace rotatebook::video
