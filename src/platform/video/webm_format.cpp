// VP9 in WebM.
#include <algorithm>

#include "video/pixel_converter.h"
#include "video/stages.h"

namespace rotatebook::video {
namespace {

// libvpx's constant quality, 0 to 63; looks like H.264 at crf 18.
constexpr const char* kQuality = "24";
// libvpx's cpu-used at deadline good: from 0, the best, to 8, the fastest.
constexpr const char* kEffort = "4";

Handle<AVCodecContext> describe(const VideoSettings& settings) {
  const AVCodec& encoder = encoderNamed(rowOf(VideoFormat::WebM).encoder);
  Handle<AVCodecContext> context = makeContext(encoder, settings);
  context->pix_fmt = settings.transparent ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P;
  tagBt709(*context);
  context->thread_count = 1;  // The bytes depend on it.
  context->gop_size =
      std::max(1, static_cast<int>(settings.frameRate.framesIn(settings.keyFrameInterval)));
  return context;
}

}  // namespace

Stages makeWebmStages(const VideoSettings& settings) {
  requireEvenSize(settings, "VP9");
  Dictionary options;
  options.set("deadline", "good");
  options.set("cpu-used", kEffort);
  options.set("crf", kQuality);
  options.set("b", "0");  // With crf: constant quality at any bit rate.
  // The encoder of the alpha doesn't support frames that aren't shown.
  if (settings.transparent) options.set("auto-alt-ref", "0");
  return {std::make_unique<PixelConverter>(settings.width, settings.height, settings.transparent),
          Encoder("VP9", describe(settings), options)};
}

}  // namespace rotatebook::video
