#include "timeline/simulate_scene.h"

#include <cstdint>
#include <utility>

#include "base/error.h"
#include "physics/simulate.h"

namespace rotatebook::timeline {
namespace {

physics::Trajectory simulate(const scene::Scene& scene, const scene::Panel& panel,
                             const std::atomic<bool>* stop) {
  try {
    return physics::simulate(panel.motion(), frameTimes(scene), stop);
  } catch (const InputError& error) {
    const std::string file = (scene.folder / (scene.name + ".toml")).string();
    const std::string panelName = panel.label.empty() ? "" : "the panel \"" + panel.label + "\": ";
    throw InputError(file + ": " + panelName + error.what());
  }
}

}  // namespace

std::vector<double> frameTimes(const scene::Scene& scene, int parts) {
  std::vector<double> times;
  for (std::int64_t n = 0; n < parts * scene.clip.frameCount(); ++n) {
    times.push_back(timeAt(scene, static_cast<double>(n) / parts));
  }
  return times;
}

ClipMotion simulateScene(const scene::Scene& scene, const std::atomic<bool>* stop) {
  requireSameLayout();
  std::vector<physics::Trajectory> trajectories;
  for (const scene::Panel& panel : scene::motionsOf(scene)) {
    trajectories.push_back(simulate(scene, panel, stop));
  }
  return {std::move(trajectories), scene.clip.frameRate};
}

}  // namespace rotatebook::timeline
