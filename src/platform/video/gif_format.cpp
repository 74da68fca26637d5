// Animated GIF.
#include "video/palette_converter.h"
#include "video/stages.h"

namespace rotatebook::video {
namespace {

/// Returns n, where taking every n-th picture gives at most kMaxGifRate pictures a second.
int takenEvery(const FrameRate& rate) {
  const int limit = rate.denominator * kMaxGifRate;
  return (rate.numerator + limit - 1) / limit;
}

}  // namespace

Stages makeGifStages(const VideoSettings& settings) {
  const int every = takenEvery(settings.frameRate);
  VideoSettings taken = settings;
  taken.frameRate.denominator *= every;
  Handle<AVCodecContext> context =
      makeContext(encoderNamed(rowOf(VideoFormat::Gif).encoder), taken);
  context->pix_fmt = AV_PIX_FMT_PAL8;
  context->thread_count = 1;
  Dictionary options;
  return {std::make_unique<PaletteConverter>(settings.width, settings.height, every),
          Encoder("GIF", std::move(context), options),
          {{"loop", "0"}}};  // for ever
}

}  // namespace rotatebook::video
