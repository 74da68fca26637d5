#include "report/verify_report.h"

#include <cstdint>
#include <iomanip>
#include <ranges>
#include <vector>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::report {
namespace {

using verify::ClipCheck;
using verify::PictureCheck;
using verify::Verification;

constexpr int kVerdictWidth = 8;
constexpr int kCheckWidth = 13;

void printCheck(const ClipCheck& check, std::ostream& out) {
  out << "  " << std::left << std::setw(kVerdictWidth) << (check.passed ? "ok" : "FAILED")
      << std::setw(kCheckWidth) << check.what << check.measured;
  const bool same = check.measured == check.wanted;
  out << " (" << (same ? "as it must be" : check.wanted) << ")\n";
}

std::string numberText(double value) {
  return roundedText(value, 3);
}

/// Converts to a check that is printed like the others.
ClipCheck asClipCheck(const PictureCheck& check) {
  std::string measured = "off by " + numberText(check.measured.rms) + " of 255, " +
                         numberText(check.measured.worstBlock) + " in the worst block";
  if (check.closerTo) {
    measured += "; it is closer to frame " + std::to_string(*check.closerTo);
  }
  return {"frame " + std::to_string(check.frame), measured,
          "at most " + numberText(check.bound.rms) + " and " + numberText(check.bound.worstBlock),
          check.passed()};
}

std::string framesText(const Verification& found) {
  const std::string count = std::to_string(found.wholeCount);
  if (!found.record.part) return count + " frames";
  return "frames " + rangeText(found.range) + " of " + count;
}

/// Returns "0, 12, 25"; of many only the first.
std::string framesCompared(const Verification& found) {
  constexpr std::size_t kMaxNamed = 12;
  return joinedOf(found.pictures | std::views::take(kMaxNamed),
                  [](const PictureCheck& check) { return std::to_string(check.frame); }) +
         (found.pictures.size() > kMaxNamed ? ", ..." : "");
}

std::string verdict(const Verification& found) {
  const auto compared = static_cast<std::int64_t>(found.pictures.size());
  const bool all = compared == found.range.count();
  const std::string pictures =
      std::to_string(compared) + " of " + std::to_string(found.range.count()) + " pictures";
  if (!found.proved()) {
    const std::int64_t count = found.failures();
    return "NOT PROVED: " + std::to_string(count) + (count == 1 ? " check" : " checks") +
           " failed; " + pictures + " were compared.";
  }
  if (all)
    return "Proved: the motion and all " + std::to_string(compared) +
           " pictures are those of the scene.";
  return "Proved for " + pictures + " (" + framesCompared(found) +
         "): they and the motion are those of the scene; --all compares every picture.";
}

std::string json(const ClipCheck& check) {
  return JsonObject()
      .addString("check", check.what)
      .addBool("passed", check.passed)
      .addString("measured", check.measured)
      .addString("wanted", check.wanted)
      .text();
}

std::string json(const video::Distance& distance) {
  return JsonObject()
      .addNumber("rms", distance.rms)
      .addNumber("worst_block", distance.worstBlock)
      .text();
}

std::string json(const PictureCheck& check) {
  return JsonObject()
      .add("frame", std::to_string(check.frame))
      .addBool("passed", check.passed())
      .add("measured", json(check.measured))
      .add("bound", json(check.bound))
      .add("closer_to", check.closerTo ? std::to_string(*check.closerTo) : "null")
      .text();
}

std::string json(const store::Provenance& provenance) {
  return JsonObject()
      .addString("scene", provenance.scene)
      .addString("version", provenance.program)
      .addString("renderer", provenance.renderer)
      .addString("ffmpeg", provenance.ffmpeg)
      .text();
}

std::string json(store::FrameRange range) {
  return jsonArray({std::to_string(range.first), std::to_string(range.end)});
}

}  // namespace

void reportVerification(const std::string& clip, const Verification& found, std::ostream& out) {
  const store::Provenance& provenance = found.record.provenance;
  out << oneLine(clip) << ": claims to be " << framesText(found) << " of the scene "
      << provenance.scene << ", made by rotatebook " << provenance.program << '\n';
  for (const std::string& difference : found.toolsDiffer) {
    out << "  note    " << difference << "; pixels may differ\n";
  }
  for (const ClipCheck& check : found.checks) printCheck(check, out);
  for (const PictureCheck& check : found.pictures) printCheck(asClipCheck(check), out);
  out << verdict(found) << '\n';
}

void reportVerificationAsJson(const std::string& clip, const Verification& found,
                              std::ostream& out) {
  const auto asJson = [](const auto& check) { return json(check); };
  out << JsonObject()
             .addString("clip", clip)
             .addBool("proved", found.proved())
             .add("made_with", json(found.record.provenance))
             .add("frames", json(found.range))
             .add("whole_frames", std::to_string(found.wholeCount))
             .add("tools_differ", jsonArrayOf(found.toolsDiffer, jsonString))
             .add("checks", jsonArrayOf(found.checks, asJson))
             .add("pictures", jsonArrayOf(found.pictures, asJson))
             .text()
      << '\n';
}

}  // namespace rotatebook::report
