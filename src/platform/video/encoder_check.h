// Checks that the encoder of a format is available.
#pragma once

#include <string>

#include "video/video_format.h"

namespace rotatebook::video {

/// The result of checking the encoder of a format.
struct EncoderCheck {
  VideoFormat format = VideoFormat::Mp4;
  std::string found{};  ///< Encoder that a video is made with; empty if there is none.
  /// Missing encoder or its error, else empty; for MP4 set also where `found` isn't the best.
  std::string failure{};
  std::string remedy{};  ///< Of the failure.
};

/// Starts the encoder of `format` and stops it again; its errors are returned, not thrown.
EncoderCheck checkEncoder(VideoFormat format);

}  // namespace rotatebook::video
