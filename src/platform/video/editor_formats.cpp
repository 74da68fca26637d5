// ProRes 4444 in QuickTime's container, HEVC and AV1 in MP4: for programs that cut films.
#include <algorithm>
#include <utility>

#include "video/pixel_converter.h"
#include "video/stages.h"

namespace rotatebook::video {
namespace {

// Both look like H.264 at crf 18.
constexpr const char* kHevcQuality = "20";
constexpr const char* kAv1Quality = "24";
// libaom's cpu-used of its quick mode. Measured on 60 frames of 1280x720: 1.2 s of processor time,
// SSIM 0.995; the thorough mode's fastest took 22 s for 0.997.
constexpr const char* kAv1Effort = "8";
// A tag by which QuickTime knows HEVC whose parameters are in the header. [hvc1]
constexpr unsigned kHvc1 = MKTAG('h', 'v', 'c', '1');

Handle<AVCodecContext> describe(const EncoderNeed& need, const VideoSettings& settings,
                                AVPixelFormat pixels) {
  Handle<AVCodecContext> context = makeContext(encoderNamed(need), settings);
  context->pix_fmt = pixels;
  tagBt709(*context);
  context->thread_count = 1;  // The bytes of HEVC and AV1 depend on it.
  return context;
}

Stages stagesOf(VideoFormat format, Handle<AVCodecContext> context, Dictionary& options,
                const VideoSettings& settings) {
  auto converter = std::make_unique<PixelConverter>(settings.width, settings.height,
                                                    settings.transparent, context->pix_fmt);
  return {std::move(converter),
          Encoder(std::string(rowOf(format).title), std::move(context), options),
          {{"movflags", "+faststart"},
           // The default of 1000 can't represent 1/60 s.
           {"movie_timescale", std::to_string(settings.frameRate.numerator)}}};
}

int keyFrames(const VideoSettings& settings) {
  return std::max(1, static_cast<int>(settings.frameRate.framesIn(settings.keyFrameInterval)));
}

}  // namespace

Stages makeProResStages(const VideoSettings& settings) {
  const FormatRow& row = rowOf(VideoFormat::ProRes);
  Handle<AVCodecContext> context = describe(
      row.encoder, settings, settings.transparent ? AV_PIX_FMT_YUVA444P10 : AV_PIX_FMT_YUV444P10);
  Dictionary options;
  options.set("profile", "4444");
  options.set("vendor", "apl0");  // Some programs take only files that name Apple's encoder.
  // The pictures have 8, which are coded without loss.
  options.set("alpha_bits", settings.transparent ? "8" : "0");
  return stagesOf(row.format, std::move(context), options, settings);
}

Stages makeHevcStages(const VideoSettings& settings) {
  requireEvenSize(settings, "HEVC");
  const FormatRow& row = rowOf(VideoFormat::Hevc);
  Handle<AVCodecContext> context = describe(row.encoder, settings, AV_PIX_FMT_YUV420P);
  context->codec_tag = kHvc1;
  context->gop_size = keyFrames(settings);
  Dictionary options;
  options.set("preset", "fast");
  options.set("crf", kHevcQuality);
  // Threads by the number of cores change the bytes; info would write the encoder's version.
  options.set("x265-params", "log-level=none:info=0:pools=none:frame-threads=1:wpp=0");
  return stagesOf(row.format, std::move(context), options, settings);
}

Stages makeAv1Stages(const VideoSettings& settings) {
  requireEvenSize(settings, "AV1");
  const FormatRow& row = rowOf(VideoFormat::Av1);
  Handle<AVCodecContext> context = describe(row.encoder, settings, AV_PIX_FMT_YUV420P);
  context->gop_size = keyFrames(settings);
  Dictionary options;
  options.set("usage", "realtime");
  options.set("cpu-used", kAv1Effort);
  options.set("row-mt", "0");
  options.set("crf", kAv1Quality);
  options.set("b", "0");  // With crf: constant quality at any bit rate.
  return stagesOf(row.format, std::move(context), options, settings);
}

}  // namespace rotatebook::video
