// Recordings: any bytes are refused, or give a motion whose every moment is finite and a rotation,
// and a short toss ratios within their intervals.
#include <cmath>
#include <optional>

#include "fuzz/fuzzing.h"
#include "recording/read_recording.h"
#include "recording/toss.h"

namespace {

using namespace rotatebook;

void requireSound(const recording::RecordedMoment& moment) {
  fuzzing::require(moment.attitude.coeffs().allFinite());
  fuzzing::require(std::abs(moment.attitude.norm() - 1) < 1e-9);
}

/// A toss of few readings, so that a fit doesn't take long.
void fitShort(const recording::InertialRecording& recording) {
  constexpr std::size_t kMost = 60;
  if (recording.readings.size() > kMost) return;
  const auto fit = recording::fitToss(recording, "a.csv", {.from = -1e12, .to = 1e12});
  for (const recording::Estimate& ratio : fit.ratios)
    fuzzing::require(ratio.low <= ratio.value && ratio.value <= ratio.high);
  fuzzing::require(fit.inertia.allFinite() && fit.start.allFinite());
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text = fuzzing::textOf(bytes, size);
  const recording::ReadOptions stated{.unit = "deg/s", .timeUnit = "ms", .ratesAlong = "body"};
  for (const recording::ReadOptions& options : {recording::ReadOptions{}, stated}) {
    std::optional<recording::RecordedMotion> motion;
    fuzzing::mayRefuse([&] { motion = recording::readRecording(text, "a.csv", options); });
    if (!motion) continue;
    fuzzing::require(motion->duration() > 0);
    fuzzing::require(motion->spins().uncertainty >= 0 && motion->spins().difference >= 0);
    for (const recording::RecordedMoment& moment : motion->moments()) requireSound(moment);
    requireSound(motion->at(motion->duration() / 3));
    requireSound(motion->part(0, motion->duration() / 2).moments().back());
  }
  fuzzing::mayRefuse([&] { fitShort(recording::readInertial(text, "a.csv", {})); });
  return 0;
}
