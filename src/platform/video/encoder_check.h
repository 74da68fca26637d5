// Which encoder each format wants, and whether it is there.
#pragma once

#include <string>

#include "video/video_format.h"

namespace rotatebook::video {

/// An encoder by FFmpeg's name, and what to do where FFmpeg was built without.
struct EncoderNeed {
  const char* name;
  const char* remedy;
};

/// The best encoder for `format`. Of MP4 alone another will do.
constexpr EncoderNeed encoderOf(VideoFormat format) {
  constexpr std::array<EncoderNeed, kVideoFormats.size()> kNeeds{{
      {"libx264", "install a build with libx264 (Debian, Ubuntu: libavcodec-extra)"},
      {"libvpx-vp9", "install a build with libvpx (Debian, Ubuntu: libavcodec-extra)"},
      {"gif", "install a build with GIF (Debian, Ubuntu: libavcodec-extra)"},
      {"apng", "install a build with zlib (Debian, Ubuntu: libavcodec-extra)"},
  }};
  return kNeeds[static_cast<std::size_t>(format)];
}

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
