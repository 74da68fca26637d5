// H.264 in MP4.
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "video/format_parts.h"
#include "video/pixel_converter.h"

namespace rotatebook::video {
namespace {

constexpr std::string_view kBestEncoder = "libx264";
constexpr double kSecondsBetweenKeyFrames = 2;
constexpr int kSmallestCrf = 1;
constexpr int kLargestCrf = 51;

constexpr std::array<std::string_view, 10> kPresets = {
    "ultrafast", "superfast", "veryfast", "faster",   "fast",
    "medium",    "slow",      "slower",   "veryslow", "placebo"};

void requireKnownPreset(const std::string& preset) {
  if (std::find(kPresets.begin(), kPresets.end(), preset) != kPresets.end()) return;
  std::string valid;
  for (const std::string_view name : kPresets) {
    valid += (valid.empty() ? "" : ", ") + std::string(name);
  }
  throw InputError("unknown video preset \"" + preset + "\"; valid are " + valid);
}

void validate(const VideoSettings& settings) {
  requireEvenSize(settings, "H.264");
  requireKnownPreset(settings.preset);
  // crf 0 is lossless, which H.264 has in High 4:4:4 Predictive only: not what browsers play.
  if (settings.crf < kSmallestCrf || settings.crf > kLargestCrf) {
    throw InputError("video crf " + std::to_string(settings.crf) + " is outside 1 to 51");
  }
}

const AVCodec& findEncoder() {
  const AVCodec* encoder = avcodec_find_encoder_by_name(kBestEncoder.data());
  if (encoder == nullptr) encoder = avcodec_find_encoder(AV_CODEC_ID_H264);
  if (encoder == nullptr) {
    throw MachineError(
        "FFmpeg's libavcodec has no H.264 encoder: install a build with libx264 "
        "(Debian, Ubuntu: libavcodec-extra)");
  }
  return *encoder;
}

Handle<AVCodecContext> describe(const AVCodec& encoder, const VideoSettings& settings) {
  Handle<AVCodecContext> context = makeContext(encoder, settings);
  context->pix_fmt = AV_PIX_FMT_YUV420P;
  context->profile = kProfileHigh;
  tagBt709(*context);
  context->gop_size =
      std::max(1, static_cast<int>(settings.frameRate.framesIn(kSecondsBetweenKeyFrames)));
  return context;
}

}  // namespace

Stages makeMp4Stages(const VideoSettings& settings) {
  validate(settings);
  const AVCodec& encoder = findEncoder();
  Dictionary options;
  if (encoder.name == kBestEncoder) {
    options.set("preset", settings.preset);
    options.set("crf", std::to_string(settings.crf));
    // cpu-independent: else x264 chooses algorithms by the processor, and the same scene gives
    // other bytes elsewhere. 8x8dct: else the preset ultrafast makes Baseline of what is to be
    // High.
    options.set("x264-params", "cpu-independent=1:8x8dct=1");
  }
  Encoder opened("H.264", describe(encoder, settings), options);
  return {std::make_unique<PixelConverter>(settings.width, settings.height), std::move(opened)};
}

}  // namespace rotatebook::video
