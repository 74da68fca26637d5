#include "video/format_parts.h"

#include <string>

#include "base/error.h"

namespace rotatebook::video {

Stages makeStages(VideoFormat format, const VideoSettings& settings) {
  requireSizeAndRate(settings);
  if (settings.transparent && !keepsTransparency(format)) {
    throw InputError(std::string(nameOf(format)) +
                     " can't hold a transparent picture; webm and apng can");
  }
  switch (format) {
    case VideoFormat::Mp4:
      return makeMp4Stages(settings);
    case VideoFormat::WebM:
      return makeWebmStages(settings);
    case VideoFormat::Gif:
      return makeGifStages(settings);
    case VideoFormat::Apng:
      break;
  }
  return makeApngStages(settings);
}

}  // namespace rotatebook::video
