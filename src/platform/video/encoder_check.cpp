#include "video/encoder_check.h"

#include "base/error.h"
#include "video/ffmpeg.h"
#include "video/stages.h"

namespace rotatebook::video {

EncoderCheck checkEncoder(VideoFormat format) {
  EncoderCheck check{.format = format, .failure = ffmpegFailure()};
  if (!check.failure.empty()) {
    check.remedy = kInstallFfmpeg;
    return check;
  }
  check.remedy = rowOf(format).encoder.remedy;
  silenceFfmpeg();
  VideoSettings settings;
  settings.width = settings.height = 64;
  const char* wanted = rowOf(format).encoder.name;
  const bool exists = avcodec_find_encoder_by_name(wanted) != nullptr;
  if (!exists) check.failure = std::string("FFmpeg's libavcodec has no encoder ") + wanted;
  try {
    check.found = makeStages(format, settings).encoder.name();
  } catch (const Error& error) {
    if (exists) check.failure = error.what();
  }
  return check;
}

}  // namespace rotatebook::video
