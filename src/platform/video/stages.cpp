#include "video/stages.h"

#include "base/error.h"

namespace rotatebook::video {

Stages makeStages(VideoFormat format, const VideoSettings& settings) {
  requireSizeAndRate(settings);
  if (settings.transparent && !keepsTransparency(format)) {
    throw InputError(std::string(nameOf(format)) + " can't hold a transparent picture; " +
                     listFormats(&FormatRow::name, "and", &FormatRow::keepsTransparency) + " can");
  }
  return rowOf(format).makeStages(settings);
}

}  // namespace rotatebook::video
