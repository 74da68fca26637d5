#include "pipeline/verify/stream_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/core.h>

#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::pipeline {
namespace {

const video::ColourTags kColours{"bt709", "bt709", "bt709", "tv"};

ClipCheck equality(const std::string& what, const std::string& measured,
                   const std::string& wanted) {
  return {what, measured, wanted, measured == wanted};
}

std::string codecText(const video::ClipFacts& facts) {
  return fmt::format("{} {}, {}", facts.codec, facts.profile, facts.pixelFormat);
}

std::string codecText(const video::FormatRow& format) {
  return fmt::format("{} {}", format.codec, format.recorded.profile);
}

std::string secondsText(double seconds) {
  return roundedText(seconds, 6) + " s";
}

std::string milliseconds(double seconds) {
  return roundedText(seconds * 1e3, 3) + " ms";
}

std::string coloursText(const video::ColourTags& tags) {
  return fmt::format("primaries {}, transfer {}, matrix {}, range {}", tags.primaries,
                     tags.transfer, tags.matrix, tags.range);
}

/// Returns the colours and pixel aspect ratio that are valid for a picture.
std::string tagsText(const video::ColourTags& colours, const std::string& shape) {
  return coloursText(colours) + ", pixels " + shape;
}

std::string shapesText(const std::string& container, const std::string& stream) {
  return fmt::format("{} in the container, {} in the stream", container, stream);
}

/// Returns a text of the pixels cut off at left, top, right and bottom; empty if they only fill up
/// the last macroblocks.
std::string cropText(const std::array<std::int64_t, 4>& crop) {
  constexpr std::int64_t kMacroblock = 16;
  const auto [left, top, right, bottom] = crop;
  if (left == 0 && top == 0 && right < kMacroblock && bottom < kMacroblock) return "";
  return fmt::format("{}, {}, {} and {} pixels at left, top, right and bottom", left, top, right,
                     bottom);
}

ClipCheck sizeCheck(const video::ClipFacts& facts, const scene::Scene& scene) {
  return equality(kSizeCheck, sizeText(facts.width, facts.height),
                  sizeText(scene.clip.width, scene.clip.height));
}

ClipCheck displayCheck(const video::ClipFacts& facts) {
  return equality("display", facts.display, "as stored");
}

ClipCheck titleCheck(const std::string& title, const std::string& wanted) {
  constexpr std::size_t kMaxLetters = 200;
  return {"title", oneLine(title, kMaxLetters), oneLine(wanted, kMaxLetters), title == wanted};
}

const video::RecordedStream& wantedOf(const video::ClipFacts& facts) {
  return rowOf(facts.format).recorded;
}

}  // namespace

std::vector<ClipCheck> checkStream(const video::ClipFacts& facts, const scene::Scene& scene) {
  const std::string colours = coloursText(kColours);
  return {sizeCheck(facts, scene),
          equality(kCodecCheck, codecText(facts), codecText(rowOf(facts.format))),
          equality("colours", coloursText(facts.colours), colours),
          equality("container", coloursText(facts.containerColours), colours),
          equality("pixel shape", shapesText(facts.containerShape, facts.pixelShape),
                   shapesText("1:1", "1:1")),
          displayCheck(facts),
          titleCheck(facts.title, scene.title)};
}

std::vector<ClipCheck> checkBrowserStream(const video::ClipFacts& facts,
                                          const scene::Scene& scene) {
  return {sizeCheck(facts, scene), displayCheck(facts), titleCheck(facts.title, scene.title)};
}

std::vector<ClipCheck> checkForm(const video::FormDifferences& found) {
  const auto check = [](const char* what, const std::string& difference) {
    const char* wanted = "as rotatebook writes it";
    return equality(what, difference.empty() ? wanted : difference, wanted);
  };
  return {check("layout", found.container), check("coding", found.stream)};
}

void DisplayCheck::add(const video::PictureFacts& picture) {
  const std::string where = fmt::format(" in picture {}", count_++);
  const auto keepFirst = [&](std::string& kept, const std::string& text) {
    if (kept.empty() && !text.empty()) kept = text + where;
  };
  const std::string tags = tagsText(picture.colours, picture.pixelShape);
  keepFirst(tags_, tags == tagsText(kColours, "1:1") ? "" : tags);
  keepFirst(alpha_, picture.alpha && !transparent_ ? "some" : "");
  keepFirst(interlaced_, picture.interlaced ? "interlaced" : "");
  keepFirst(cropped_, cropText(picture.crop));
  keepFirst(messages_, picture.messages);
}

std::vector<ClipCheck> DisplayCheck::checks(const video::ClipFacts& facts) const {
  const auto orElse = [](const std::string& text, const std::string& other) {
    return text.empty() ? other : text;
  };
  const std::string tags = tagsText(kColours, "1:1");
  return {equality("tags", orElse(tags_, tags), tags),
          equality("alpha", orElse(alpha_, transparent_ ? "the scene's" : "none"),
                   transparent_ ? "the scene's" : "none"),
          equality("scan", orElse(interlaced_, facts.scan), "progressive"),
          equality("coded crop", orElse(cropped_, "none"), "none"),
          equality("messages", orElse(messages_, "none"), "none")};
}

TimeCheck::TimeCheck(const video::ClipFacts& facts, FrameRate rate, std::int64_t frames)
    : facts_(facts), rate_(rate), frames_(frames) {}

double TimeCheck::timeOf(std::int64_t frame) const {
  return static_cast<double>(frame) * rate_.denominator / rate_.numerator;
}

void TimeCheck::add(double time) {
  const double error = std::abs(time - timeOf(count_++));
  allHaveTimes_ = allHaveTimes_ && std::isfinite(error);
  if (std::isfinite(error)) largestError_ = std::max(largestError_, error);
}

std::vector<ClipCheck> TimeCheck::checks() const {
  const double stampBound = wantedOf(facts_).stampBound;
  const double lengthBound = wantedOf(facts_).lengthBound;
  const double wanted = timeOf(frames_);
  return {equality("frames", std::to_string(count_), std::to_string(frames_)),
          {"time stamps",
           allHaveTimes_ ? "off by up to " + milliseconds(largestError_) : "some are missing",
           "frame n at n/fps within " + milliseconds(stampBound),
           allHaveTimes_ && largestError_ <= stampBound},
          {"duration", secondsText(facts_.duration),
           fmt::format("{} within {}", secondsText(wanted), milliseconds(lengthBound)),
           std::abs(facts_.duration - wanted) <= lengthBound}};
}

}  // namespace rotatebook::pipeline
