// Recordings: any bytes are refused, or give a motion whose every moment is finite and a rotation,
// and finite readings of sensors. What follows a form feed is an accelerometer's table.
#include <algorithm>
#include <cmath>
#include <optional>

#include "fuzz/fuzzing.h"
#include "recording/inertial_recording.h"
#include "recording/read_recording.h"

namespace {

using namespace rotatebook;

void requireSound(const recording::RecordedMoment& moment) {
  fuzzing::require(moment.attitude.coeffs().allFinite());
  fuzzing::require(std::abs(moment.attitude.norm() - 1) < 1e-9);
}

void requireFinite(const recording::InertialRecording& recording) {
  for (const recording::InertialReading& one : recording.readings)
    fuzzing::require(one.rate.angularVelocity.allFinite() && !one.force.hasNaN());
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
  static_cast<void>(recording::contentsOf({text, "Gyroscope.csv"}, {}));
  fuzzing::mayRefuse([&] { requireFinite(recording::readInertial(text, "a.csv", {})); });
  const std::size_t end = std::min(text.find('\f'), text.size());
  if (end == text.size()) return 0;
  const recording::NamedTable second{text.substr(end + 1), "TotalAcceleration.csv"};
  fuzzing::mayRefuse([&] {
    requireFinite(recording::readInertial(text.substr(0, end), "Gyroscope.csv", {}, &second));
  });
  return 0;
}
