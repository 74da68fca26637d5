// Whether the encoder of a format is there.
#pragma once

#include <string>

#include "video/video_format.h"

namespace rotatebook::video {

/// What was found for a format.
struct EncoderCheck {
  VideoFormat format = VideoFormat::Mp4;
  std::string found{};  ///< The encoder that a video is made with; empty if there is none.
  std::string
      failure{};  ///< What lacks or failed, or empty; of MP4 also where `found` isn't the best.
};

/// Starts the encoder of `format`, and ends it again. Throws nothing that an encoder does.
EncoderCheck checkEncoder(VideoFormat format);

}  // namespace rotatebook::video
