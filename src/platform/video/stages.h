// The stages of writing each format. Inside the room only.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "video/converter.h"
#include "video/encoder.h"
#include "video/video_format.h"
#include "video/video_settings.h"

namespace rotatebook::video {

struct Stages {
  std::unique_ptr<Converter> converter;
  Encoder encoder;
  /// FFmpeg's options for the container.
  std::vector<std::pair<const char*, std::string>> containerOptions{};
};

/// Makes the stages of `format`. Throws InputError for settings out of range, MachineError if there
/// is no encoder or it doesn't start.
Stages makeStages(VideoFormat format, const VideoSettings& settings);

}  // namespace rotatebook::video
