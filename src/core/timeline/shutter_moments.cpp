#include "timeline/shutter_moments.h"

#include <algorithm>
#include <numeric>

#include "physics/simulate.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::timeline {

namespace {

/// Divides the runs of steps, at whose ends samples are made from no copy, into up to `parts`, a
/// power of two, which keeps a step's length to the last bit.
void makeShort(physics::SimulationSettings& settings, int parts) {
  if (settings.step) return;
  const int divisor = std::gcd(settings.substeps, parts);
  settings.substepped = settings.steps().time / divisor;
  settings.substeps /= divisor;
}

}  // namespace

ShutterMoments::ShutterMoments(const scene::Scene& scene)
    : count_(static_cast<std::size_t>(scene.look.motionBlur)) {
  if (count_ == 1) return;
  const int finer = 2 * scene.look.motionBlur;
  const std::vector<double> times = frameTimes(scene, finer);
  for (const scene::Panel& panel : scene.motions) {
    physics::MotionSettings settings = panel.motion();
    makeShort(settings.simulation, finer);
    motions_.push_back(physics::simulate(settings, times));
  }
}

const physics::Sample& ShutterMoments::at(std::size_t motion, std::size_t sample,
                                          std::size_t moment) const {
  const auto& samples = motions_[motion].samples;
  return samples[std::min(2 * count_ * sample + moment, samples.size() - 1)];
}

}  // namespace rotatebook::timeline
