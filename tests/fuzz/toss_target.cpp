// Tosses: any bytes that are read as a gyroscope's table are refused, or give ratios within their
// intervals. What follows a form feed is an accelerometer's table.
#include <algorithm>

#include "fuzz/fuzzing.h"
#include "recording/read_recording.h"
#include "recording/toss.h"

namespace {

using namespace rotatebook;

void requireSound(const recording::TossFit& fit) {
  for (const recording::Estimate& ratio : fit.ratios)
    fuzzing::require(ratio.low <= ratio.value && ratio.value <= ratio.high);
  fuzzing::require(fit.inertia.allFinite() && fit.start.allFinite() && fit.widening >= 1);
}

/// Tosses of few readings, so that a fit doesn't take long.
void fitShort(const recording::InertialRecording& recording) {
  constexpr std::size_t kMaxReadings = 60;
  if (recording.readings.size() > kMaxReadings) return;
  for (const recording::Throw& one : recording::findThrows(recording, "a.csv", {})) {
    fuzzing::require(one.fit.has_value() != !one.refusal.empty());
    if (one.fit) requireSound(*one.fit);
  }
  requireSound(recording::fitToss(recording, "a.csv", {.from = -1e12, .to = 1e12}));
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text = fuzzing::textOf(bytes, size);
  const std::size_t end = std::min(text.find('\f'), text.size());
  const recording::NamedTable second{text.substr(std::min(end + 1, text.size())),
                                     "TotalAcceleration.csv"};
  fuzzing::mayRefuse([&] {
    fitShort(end == text.size()
                 ? recording::readInertial(text, "a.csv", {})
                 : recording::readInertial(text.substr(0, end), "Gyroscope.csv", {}, &second));
  });
  return 0;
}
