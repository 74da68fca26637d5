// The form of a clip's file, and the coded pictures in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/frame_rate.h"
#include "video/video_settings.h"

namespace rotatebook::video {

/// The settings that the file of a clip follows from, beside its coded pictures, title and comment.
struct WrittenForm {
  int width = 0;   ///< [pixels]
  int height = 0;  ///< [pixels]
  FrameRate frameRate{};
  std::int64_t frames = 0;   ///< The number of pictures.
  bool transparent = false;  ///< The pictures have alpha.
  int crf = 18;              ///< MP4: VideoSettings::crf
  /// MP4: VideoSettings::preset; if empty, the settings in the encoder's note aren't compared.
  std::string preset{};
  std::vector<Chapter> chapters{};  ///< VideoSettings::chapters
};

/// The coded pictures of a file and its texts, as FFmpeg reads them.
struct Payload {
  std::vector<std::uint64_t> sizes{};   ///< Of the packets. [bytes]
  std::vector<std::uint64_t> delays{};  ///< Of their times from decoding to showing. [ticks]
  std::vector<std::size_t> keys{};      ///< Indices of those that are key frames, ascending.
  std::int64_t delay = 0;               ///< The first of `delays`. [frames]
  std::string title{};
  std::string comment{};
};

}  // namespace rotatebook::video
