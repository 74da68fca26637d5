#include "page/motion_data.h"

#include <cmath>

#include "base/json.h"
#include "base/number_text.h"
#include "base/text.h"

namespace rotatebook::page {
namespace {

using physics::Sample;

// More wouldn't show in a plot of any size.
constexpr int kPlotDigits = 6;

std::string numberOrNull(double number) {
  return std::isfinite(number) ? roundedText(number, kPlotDigits) : "null";
}

/// Returns an array of one number for each sample, without spaces, as there are thousands.
template <typename Value>
std::string numbers(const physics::Trajectory& trajectory, const Value& value) {
  std::vector<std::string> texts;
  for (const Sample& sample : trajectory.samples) texts.push_back(numberOrNull(value(sample)));
  return "[" + joined(texts, ",") + "]";
}

std::string timesOf(const scene::Scene& scene, std::int64_t frames) {
  std::vector<std::string> texts;
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    texts.push_back(numberOrNull(timeAt(scene, static_cast<double>(frame))));
  }
  return "[" + joined(texts, ",") + "]";
}

std::string motionJson(const Motion& motion) {
  const physics::Trajectory& trajectory = motion.trajectory;
  const double start = trajectory.samples.front().total();
  const auto ratio = [&](double (*energy)(const Sample&)) {
    return numbers(trajectory, [=](const Sample& sample) { return energy(sample) / start; });
  };
  return JsonObject()
      .addString("label", motion.panel.label)
      .addBool("springs", motion.panel.simulation.model == physics::Model::Particles)
      .add("kinetic", ratio([](const Sample& sample) { return sample.kinetic; }))
      .add("potential", ratio([](const Sample& sample) { return sample.potential; }))
      .add("total", ratio([](const Sample& sample) { return sample.total(); }))
      .add("tilt", numbers(trajectory, [](const Sample& sample) { return sample.tiltDeg; }))
      .add("error", numbers(trajectory, [](const Sample& sample) { return sample.errorDeg; }))
      .text();
}

}  // namespace

std::string motionData(const std::vector<Motion>& motions, const scene::Scene& scene,
                       std::int64_t frames, const std::string& checksum) {
  const FrameRate& rate = scene.clip.frameRate;
  JsonObject data;
  data.add("rate", jsonArray({std::to_string(rate.numerator), std::to_string(rate.denominator)}))
      .add("frames", std::to_string(frames))
      .addNumber("interval", motions.front().trajectory.interval);
  if (!hasEvenTimes(scene)) data.add("times", timesOf(scene, frames));
  if (!checksum.empty()) data.addString("checksum", checksum);
  return data.add("motions", jsonArrayOf(motions, motionJson)).text();
}

}  // namespace rotatebook::page
