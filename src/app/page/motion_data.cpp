#include "page/motion_data.h"

#include <cmath>

#include "base/number_text.h"
#include "page/html.h"

namespace rotatebook::page {
namespace {

using physics::Sample;

// No plot is so large that more would show.
constexpr int kPlotDigits = 6;

template <typename Value>
std::string numbers(const physics::Trajectory& trajectory, const Value& value) {
  std::string json;
  for (const Sample& sample : trajectory.samples) {
    const double number = value(sample);
    json += (json.empty() ? "" : ",") +
            (std::isfinite(number) ? roundedText(number, kPlotDigits) : std::string("null"));
  }
  return "[" + json + "]";
}

std::string motionJson(const Motion& motion) {
  const physics::Trajectory& trajectory = motion.trajectory;
  const double start = trajectory.samples.front().total();
  const bool springs = motion.panel.simulation.model == physics::Model::Particles;
  const auto ratio = [&](double (*energy)(const Sample&)) {
    return numbers(trajectory, [=](const Sample& sample) { return energy(sample) / start; });
  };
  return "{\"label\":" + jsonString(motion.panel.label) +
         ",\"springs\":" + (springs ? "true" : "false") +
         ",\"kinetic\":" + ratio([](const Sample& sample) { return sample.kinetic; }) +
         ",\"potential\":" + ratio([](const Sample& sample) { return sample.potential; }) +
         ",\"total\":" + ratio([](const Sample& sample) { return sample.total(); }) +
         ",\"tilt\":" + numbers(trajectory, [](const Sample& sample) { return sample.tiltDeg; }) +
         ",\"error\":" + numbers(trajectory, [](const Sample& sample) { return sample.errorDeg; }) +
         "}";
}

}  // namespace

std::string motionData(const std::vector<Motion>& motions, const scene::ClipSettings& clip,
                       std::int64_t frames) {
  std::string json;
  for (const Motion& motion : motions) json += (json.empty() ? "" : ",") + motionJson(motion);
  return "{\"rate\":[" + std::to_string(clip.frameRate.numerator) + "," +
         std::to_string(clip.frameRate.denominator) + "],\"frames\":" + std::to_string(frames) +
         ",\"interval\":" + shortestText(motions.front().trajectory.interval) + ",\"motions\":[" +
         json + "]}";
}

}  // namespace rotatebook::page
