#include "pipeline/stream_checks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/number_text.h"

namespace rotatebook::pipeline {
namespace {

// WebM counts milliseconds; MP4's clock divides a frame without rest. [s]
constexpr double kMp4Stamp = 1e-6, kWebmStamp = 0.501e-3;
// FFmpeg tells it in microseconds. [s]
constexpr double kMp4Length = 2e-6, kWebmLength = 1.001e-3;

ClipCheck equality(const std::string& what, const std::string& measured,
                   const std::string& wanted) {
  return {what, measured, wanted, measured == wanted};
}

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

std::string codecText(const video::ClipFacts& facts) {
  return facts.codec + " " + facts.profile + ", " + facts.pixelFormat;
}

std::string secondsText(double seconds) {
  return roundedText(seconds, 6) + " s";
}

std::string milliseconds(double seconds) {
  return roundedText(seconds * 1e3, 3) + " ms";
}

bool isMp4(const video::ClipFacts& facts) {
  return facts.format == video::VideoFormat::Mp4;
}

}  // namespace

std::vector<ClipCheck> checkStream(const video::ClipFacts& facts, const scene::Scene& scene) {
  const std::string colours = "primaries " + facts.primaries + ", transfer " + facts.transfer +
                              ", matrix " + facts.matrix + ", range " + facts.range;
  return {equality(kSizeCheck, sizeText(facts.width, facts.height),
                   sizeText(scene.clip.width, scene.clip.height)),
          equality(kCodecCheck, codecText(facts),
                   isMp4(facts) ? "h264 High, yuv420p" : "vp9 Profile 0, yuv420p"),
          equality("colours", colours, "primaries bt709, transfer bt709, matrix bt709, range tv")};
}

TimeCheck::TimeCheck(const video::ClipFacts& facts, FrameRate rate, std::int64_t frames)
    : facts_(facts), rate_(rate), frames_(frames) {}

double TimeCheck::timeOf(std::int64_t frame) const {
  return static_cast<double>(frame) * rate_.denominator / rate_.numerator;
}

void TimeCheck::add(double time) {
  const double away = std::abs(time - timeOf(count_++));
  allHaveTimes_ = allHaveTimes_ && std::isfinite(away);
  if (std::isfinite(away)) farthest_ = std::max(farthest_, away);
}

std::vector<ClipCheck> TimeCheck::checks() const {
  const double stamp = isMp4(facts_) ? kMp4Stamp : kWebmStamp;
  const double length = isMp4(facts_) ? kMp4Length : kWebmLength;
  const double wanted = timeOf(frames_);
  return {equality("frames", std::to_string(count_), std::to_string(frames_)),
          {"time stamps",
           allHaveTimes_ ? "off by up to " + milliseconds(farthest_) : "some are missing",
           "frame n at n/fps within " + milliseconds(stamp), allHaveTimes_ && farthest_ <= stamp},
          {"duration", secondsText(facts_.duration),
           secondsText(wanted) + " within " + milliseconds(length),
           std::abs(facts_.duration - wanted) <= length}};
}

}  // namespace rotatebook::pipeline
