// H.264 in MP4.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/clip_limits.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "video/coded_units.h"
#include "video/pixel_converter.h"
#include "video/stages.h"

namespace rotatebook::video {
namespace {

constexpr EncoderNeed kBestEncoder = rowOf(VideoFormat::Mp4).encoder;

void requireKnownPreset(const std::string& preset) {
  if (std::find(kVideoPresets.begin(), kVideoPresets.end(), preset) != kVideoPresets.end()) return;
  throw InputError(fmt::format("unknown video preset \"{}\"; valid are {}", preset,
                               joined({kVideoPresets.begin(), kVideoPresets.end()})));
}

void validate(const VideoSettings& settings) {
  requireEvenSize(settings, "H.264");
  requireKnownPreset(settings.preset);
  if (settings.crf < kBestCrf || settings.crf > kWorstCrf) {
    throw InputError(
        fmt::format("video crf {} is outside {} to {}", settings.crf, kBestCrf, kWorstCrf));
  }
}

const AVCodec& findEncoder() {
  const AVCodec* encoder = avcodec_find_encoder_by_name(kBestEncoder.name);
  if (encoder == nullptr) encoder = avcodec_find_encoder(AV_CODEC_ID_H264);
  if (encoder == nullptr) {
    throw MachineError(std::string("FFmpeg's libavcodec has no H.264 encoder: ") +
                       kBestEncoder.remedy);
  }
  return *encoder;
}

Handle<AVCodecContext> describe(const AVCodec& encoder, const VideoSettings& settings) {
  Handle<AVCodecContext> context = makeContext(encoder, settings);
  context->pix_fmt = AV_PIX_FMT_YUV420P;
  context->profile = kProfileHigh;
  tagBt709(*context);
  context->gop_size =
      std::max(1, static_cast<int>(settings.frameRate.framesIn(settings.keyFrameInterval)));
  return context;
}

// The book's own preset starts from the fastest of x264's that searches for motion as it should. It
// has no macroblock tree, whose lookahead costs a third of the time, as most macroblocks don't
// move. It always takes three B-frames and detects no scene cuts, as there are none: otherwise both
// would need a lookahead, too. With less aq-strength than veryfast's, quality moves from the
// background to the colours of the cover, with finer colours still more. No arithmetic coding keeps
// the similarity, in larger files. Neither blocks of 8 x 8 predicted within a picture nor
// deblocking: 4 % less time at the same similarity, 17 % under stars.
//
// Measured on frames 120 to 239 of scenes/figures/fig05-unstable-x.toml, fig06-undamped.toml and
// scenes/comparisons/axes.toml at crf 18, x264's processor time [ms a frame], size [MB], similarity
// to the frames (SSIM of Y, the least of U and V):
//   before    3.2 3.2 3.4   2.01 2.94 2.25   0.9959 0.9968 0.9954   0.9952 0.9920 0.9940
//   book      4.4 4.2 4.6   1.68 2.53 1.65   0.9960 0.9968 0.9953   0.9951 0.9920 0.9935
// Before: subme=0, two B-frames, aq-strength 0.5. Arithmetic coding takes another 8 % off the size
// for 0.8 ms, 8 x 8 blocks of motion 8 to 10 % for 1 ms.
constexpr std::string_view kBookBase = "superfast";
constexpr std::string_view kBookParams =
    ":b-adapt=0:bframes=3:weightp=0:scenecut=0:aq-strength=0.65:chroma-qp-offset=-1:subme=2"
    ":cabac=0:partitions=i4x4:no-deblock=1";
// At the same rate factor it would be even closer to the frames than medium, and larger.
constexpr double kBookCrfOffset = 0.6;

double rateFactorOf(int crf, std::string_view preset) {
  return preset == kBookPreset ? std::min(crf + kBookCrfOffset, 1.0 * kWorstCrf) : crf;
}

void setX264Options(const VideoSettings& settings, Dictionary& options) {
  const bool book = settings.preset == kBookPreset;
  const double crf = rateFactorOf(settings.crf, settings.preset);
  options.set("preset", book ? std::string(kBookBase) : settings.preset);
  options.set("crf", shortestText(crf));
  // cpu-independent: otherwise x264 chooses algorithms by the processor, and the same scene gives
  // other bytes elsewhere; costs 2 to 4 %. 8x8dct: otherwise the preset ultrafast makes Baseline
  // instead of High.
  std::string params = "cpu-independent=1:8x8dct=1";
  if (book) params += kBookParams;
  options.set("x264-params", params);
}

}  // namespace

std::vector<std::string> noteSettings(int crf, std::string_view preset) {
  std::vector<std::string> settings = presetSettings(preset);
  settings.push_back(fmt::format("crf={:.1f}", rateFactorOf(crf, preset)));
  return settings;
}

std::vector<std::string> presetSettings(std::string_view preset) {
  // Of kVideoPresets, with what kBookParams says of the first.
  constexpr std::array<int, kVideoPresets.size()> kSubme{2, 0, 1, 2, 4, 6, 7, 8, 9, 10, 11};
  const auto place = std::ranges::find(kVideoPresets, preset) - kVideoPresets.begin();
  std::vector<std::string> settings{
      "rc=crf", "8x8dct=1", fmt::format("subme={}", kSubme.at(static_cast<std::size_t>(place)))};
  if (preset != kBookPreset) return settings;
  for (const char* own : {"weightp=0", "scenecut=0", "aq=1:0.65", "cabac=0", "deblock=0:0:0"})
    settings.emplace_back(own);
  return settings;
}

Stages makeMp4Stages(const VideoSettings& settings) {
  validate(settings);
  const AVCodec& encoder = findEncoder();
  Dictionary options;
  if (encoder.name == std::string_view(kBestEncoder.name)) {
    setX264Options(settings, options);
  }
  Encoder opened("H.264", describe(encoder, settings), options);
  return {std::make_unique<PixelConverter>(settings.width, settings.height),
          std::move(opened),
          {{"movflags", "+faststart"},
           // The default of 1000 can't represent 1/60 s.
           {"movie_timescale", std::to_string(settings.frameRate.numerator)}}};
}

}  // namespace rotatebook::video
