#include "video/stages.h"

#include <fmt/core.h>

#include "base/error.h"

namespace rotatebook::video {

Stages makeStages(VideoFormat format, const VideoSettings& settings) {
  requireSizeAndRate(settings);
  if (settings.transparent && !keepsTransparency(format)) {
    throw InputError(
        fmt::format("{} can't hold a transparent picture; {} can", nameOf(format),
                    listFormats(&FormatRow::name, "and", &FormatRow::keepsTransparency)));
  }
  return rowOf(format).makeStages(settings);
}

}  // namespace rotatebook::video
