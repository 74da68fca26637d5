#include "video/h264_encoder.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/error.h"

namespace rotatebook::video {
namespace {

constexpr std::string_view kBestEncoder = "libx264";
constexpr double kSecondsBetweenKeyFrames = 2;
constexpr int kSmallestCrf = 1;
constexpr int kLargestCrf = 51;

constexpr std::array<std::string_view, 10> kPresets = {
    "ultrafast", "superfast", "veryfast", "faster",   "fast",
    "medium",    "slow",      "slower",   "veryslow", "placebo"};

void requireEncodable(const char* side, int pixels) {
  const std::string text = std::string("video ") + side + " " + std::to_string(pixels);
  if (pixels < kSmallestSide) {
    throw InputError(text + ": the smallest is " + std::to_string(kSmallestSide));
  }
  if (pixels % 2 == 0) return;
  throw InputError(text + " is odd, and H.264's 4:2:0 colour needs it even: take " +
                   std::to_string(pixels - 1) + " or " + std::to_string(pixels + 1));
}

void requireKnownPreset(const std::string& preset) {
  if (std::find(kPresets.begin(), kPresets.end(), preset) != kPresets.end()) return;
  std::string valid;
  for (const std::string_view name : kPresets) {
    valid += (valid.empty() ? "" : ", ") + std::string(name);
  }
  throw InputError("unknown video preset \"" + preset + "\"; valid are " + valid);
}

void validate(const VideoSettings& settings) {
  requireEncodable("width", settings.width);
  requireEncodable("height", settings.height);
  requireKnownPreset(settings.preset);
  if (settings.frameRate.numerator <= 0 || settings.frameRate.denominator <= 0) {
    throw InputError("video frame rate " + settings.frameRate.text() + " isn't above 0");
  }
  // crf 0 is lossless, which H.264 has in High 4:4:4 Predictive only: not what browsers play.
  if (settings.crf < kSmallestCrf || settings.crf > kLargestCrf) {
    throw InputError("video crf " + std::to_string(settings.crf) + " is outside 1 to 51");
  }
  if (settings.threads < 1) {
    throw InputError("video threads " + std::to_string(settings.threads) + ": at least 1");
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

void describe(AVCodecContext& context, const VideoSettings& settings) {
  context.width = settings.width;
  context.height = settings.height;
  context.sample_aspect_ratio = {1, 1};
  context.pix_fmt = AV_PIX_FMT_YUV420P;
  context.profile = kProfileHigh;
  context.color_primaries = AVCOL_PRI_BT709;
  context.color_trc = AVCOL_TRC_BT709;
  context.colorspace = AVCOL_SPC_BT709;
  context.color_range = AVCOL_RANGE_MPEG;
  context.chroma_sample_location = AVCHROMA_LOC_LEFT;
  context.framerate = {settings.frameRate.numerator, settings.frameRate.denominator};
  context.time_base = {settings.frameRate.denominator, settings.frameRate.numerator};
  context.gop_size =
      std::max(1, static_cast<int>(settings.frameRate.framesIn(kSecondsBetweenKeyFrames)));
  context.thread_count = settings.threads;
  context.flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
}

}  // namespace

H264Encoder::H264Encoder(const VideoSettings& settings) {
  validate(settings);
  const AVCodec& encoder = findEncoder();
  name_ = encoder.name;
  context_ = owned(avcodec_alloc_context3(&encoder));
  packet_ = owned(av_packet_alloc());
  describe(*context_, settings);
  Dictionary options;
  if (name_ == kBestEncoder) {
    options.set("preset", settings.preset);
    options.set("crf", std::to_string(settings.crf));
    // cpu-independent: else x264 chooses algorithms by the processor, and the same scene gives
    // other bytes elsewhere. 8x8dct: else the preset ultrafast makes Baseline of what is to be
    // High.
    options.set("x264-params", "cpu-independent=1:8x8dct=1");
  }
  check(avcodec_open2(context_.get(), &encoder, options.address()),
        "the H.264 encoder " + name_ + " doesn't start");
}

void H264Encoder::send(AVFrame* frame) {
  check(avcodec_send_frame(context_.get(), frame), "the H.264 encoder " + name_ + " failed");
}

AVPacket* H264Encoder::receive() {
  const int result = avcodec_receive_packet(context_.get(), packet_.get());
  if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return nullptr;
  check(result, "the H.264 encoder " + name_ + " failed");
  // x264's packets carry none, and the muxer would have to guess the last one's.
  packet_->duration = 1;
  return packet_.get();
}

}  // namespace rotatebook::video
