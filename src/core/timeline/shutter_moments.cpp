#include "timeline/shutter_moments.h"

#include <algorithm>

#include "physics/simulate.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::timeline {

ShutterMoments::ShutterMoments(const scene::Scene& scene)
    : count_(static_cast<std::size_t>(scene.look.motionBlur)) {
  if (count_ == 1) return;
  const int finer = 2 * scene.look.motionBlur;
  const std::vector<double> times = frameTimes(scene, finer);
  for (const scene::Panel& panel : scene::motionsOf(scene)) {
    physics::MotionSettings settings = panel.motion();
    // Divide both by a power of two, which keeps the step's length to the last bit.
    settings.simulation.timePerFrame /= finer;
    settings.simulation.substeps = std::max(1, settings.simulation.substeps / finer);
    motions_.push_back(physics::simulate(settings, times));
  }
}

const physics::Sample& ShutterMoments::at(std::size_t motion, std::size_t sample,
                                          std::size_t moment) const {
  const auto& samples = motions_[motion].samples;
  return samples[std::min(2 * count_ * sample + moment, samples.size() - 1)];
}

}  // namespace rotatebook::timeline
