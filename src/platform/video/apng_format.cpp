// Animated PNG.
#include "video/rgb_converter.h"
#include "video/stages.h"

namespace rotatebook::video {

Stages makeApngStages(const VideoSettings& settings) {
  Handle<AVCodecContext> context =
      makeContext(encoderNamed(rowOf(VideoFormat::Apng).encoder), settings);
  context->pix_fmt = settings.transparent ? AV_PIX_FMT_RGBA : AV_PIX_FMT_RGB24;
  context->thread_count = 1;
  Dictionary options;
  options.set("pred", "mixed");  // Picks the PNG filter that suits each row.
  return {std::make_unique<RgbConverter>(settings.width, settings.height, settings.transparent),
          Encoder("APNG", std::move(context), options),
          {{"plays", "0"}}};  // for ever
}

}  // namespace rotatebook::video
