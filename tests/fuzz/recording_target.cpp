// Recordings: any bytes are refused, or give a motion whose every moment is finite and a rotation.
#include <cmath>
#include <optional>

#include "fuzz/fuzzing.h"
#include "recording/read_recording.h"

namespace {

using namespace rotatebook;

void requireSound(const recording::RecordedMoment& moment) {
  fuzzing::require(moment.attitude.coeffs().allFinite());
  fuzzing::require(std::abs(moment.attitude.norm() - 1) < 1e-9);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text = fuzzing::textOf(bytes, size);
  for (const char* unit : {"", "deg/s"}) {
    std::optional<recording::RecordedMotion> motion;
    fuzzing::mayRefuse([&] { motion = recording::readRecording(text, "a.csv", {.unit = unit}); });
    if (!motion) continue;
    fuzzing::require(motion->duration() > 0);
    for (const recording::RecordedMoment& moment : motion->moments()) requireSound(moment);
    requireSound(motion->at(motion->duration() / 3));
    requireSound(motion->part(0, motion->duration() / 2).moments().back());
  }
  fuzzing::mayRefuse([&] { recording::readInertial(text, "a.csv", {}); });
  return 0;
}
