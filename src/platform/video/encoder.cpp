#include "video/encoder.h"

#include <utility>

#include <fmt/core.h>

#include "base/error.h"

namespace rotatebook::video {
namespace {

void requireLargeEnough(const char* side, int pixels) {
  if (pixels >= kSmallestSide) return;
  throw InputError(fmt::format("video {} {}: the smallest is {}", side, pixels, kSmallestSide));
}

void requireEven(const char* side, int pixels, const std::string& codec) {
  if (pixels % 2 == 0) return;
  throw InputError(
      fmt::format("video {} {} is odd, and {}'s 4:2:0 colour needs it even: take {} or {}", side,
                  pixels, codec, pixels - 1, pixels + 1));
}

}  // namespace

Encoder::Encoder(const std::string& kind, Handle<AVCodecContext> context, Dictionary& options)
    : name_(context->codec->name),
      label_(fmt::format("the {} encoder {}", kind, name_)),
      context_(std::move(context)),
      packet_(owned(av_packet_alloc())) {
  check(avcodec_open2(context_.get(), nullptr, options.address()), label_ + " doesn't start");
}

void Encoder::send(AVFrame* frame) {
  check(avcodec_send_frame(context_.get(), frame), label_ + " failed");
}

AVPacket* Encoder::receive() {
  const int result = avcodec_receive_packet(context_.get(), packet_.get());
  if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return nullptr;
  check(result, label_ + " failed");
  // Some encoders don't set it, and the muxer would have to guess that of the last packet.
  packet_->duration = 1;
  return packet_.get();
}

const AVCodec& encoderNamed(const EncoderNeed& need) {
  const AVCodec* encoder = avcodec_find_encoder_by_name(need.name);
  if (encoder != nullptr) return *encoder;
  throw MachineError(
      fmt::format("FFmpeg's libavcodec has no encoder {}: {}", need.name, need.remedy));
}

Handle<AVCodecContext> makeContext(const AVCodec& encoder, const VideoSettings& settings) {
  Handle<AVCodecContext> context = owned(avcodec_alloc_context3(&encoder));
  context->width = settings.width;
  context->height = settings.height;
  context->sample_aspect_ratio = {1, 1};
  context->framerate = {settings.frameRate.numerator, settings.frameRate.denominator};
  context->time_base = {settings.frameRate.denominator, settings.frameRate.numerator};
  context->thread_count = settings.threads;
  context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
  return context;
}

void tagBt709(AVCodecContext& context) {
  context.color_primaries = AVCOL_PRI_BT709;
  context.color_trc = AVCOL_TRC_BT709;
  context.colorspace = AVCOL_SPC_BT709;
  context.color_range = AVCOL_RANGE_MPEG;
  context.chroma_sample_location = AVCHROMA_LOC_LEFT;
}

void requireSizeAndRate(const VideoSettings& settings) {
  requireLargeEnough("width", settings.width);
  requireLargeEnough("height", settings.height);
  if (settings.frameRate.numerator <= 0 || settings.frameRate.denominator <= 0) {
    throw InputError(fmt::format("video frame rate {} isn't above 0", settings.frameRate.text()));
  }
  if (settings.threads < 1) {
    throw InputError(fmt::format("video threads {}: at least 1", settings.threads));
  }
}

void requireEvenSize(const VideoSettings& settings, const std::string& codec) {
  requireEven("width", settings.width, codec);
  requireEven("height", settings.height, codec);
}

}  // namespace rotatebook::video
