// What each format is made of. Inside the room only.
#pragma once

#include <memory>

#include "video/converter.h"
#include "video/encoder.h"
#include "video/video_writer.h"

namespace rotatebook::video {

struct Stages {
  std::unique_ptr<Converter> converter;
  Encoder encoder;
};

/// Throws InputError for settings out of range, MachineError where there is no encoder or it
/// doesn't start.
Stages makeStages(VideoFormat format, const VideoSettings& settings);

// One function a format.

/// The best H.264 encoder that FFmpeg was built with: libx264, else the next. High profile,
/// yuv420p, a key frame every two seconds at most.
Stages makeMp4Stages(const VideoSettings& settings);
/// libvpx's VP9 at constant quality, on one thread.
Stages makeWebmStages(const VideoSettings& settings);
Stages makeGifStages(const VideoSettings& settings);
Stages makeApngStages(const VideoSettings& settings);

}  // namespace rotatebook::video
