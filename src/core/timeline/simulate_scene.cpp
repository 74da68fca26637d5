#include "timeline/simulate_scene.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/error.h"

namespace rotatebook::timeline {
namespace {

std::string nameOf(const scene::Scene& scene, const scene::Panel& panel) {
  const std::string file = (scene.folder / (scene.name + ".toml")).string();
  return file + ": " + (panel.label.empty() ? "" : "the panel \"" + panel.label + "\": ");
}

/// Calls `act`, and puts `name` before the message of an InputError.
template <typename Act>
auto named(const std::string& name, const Act& act) {
  try {
    return act();
  } catch (const InputError& error) {
    throw InputError(name + error.what());
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

SceneSimulation::SceneSimulation(const scene::Scene& scene)
    : rate_(scene.clip.frameRate), times_(frameTimes(scene)) {
  requireSameLayout();
  for (const scene::Panel& panel : scene::motionsOf(scene)) {
    names_.push_back(nameOf(scene, panel));
    simulations_.push_back(
        named(names_.back(), [&] { return physics::Simulation(panel.motion()); }));
  }
}

void SceneSimulation::advance() {
  if (isComplete()) return;
  const double time = times_[static_cast<std::size_t>(frames_)];
  for (std::size_t i = 0; i < simulations_.size(); ++i) {
    named(names_[i], [&] { return simulations_[i].sample(time); });
  }
  ++frames_;
}

bool SceneSimulation::isComplete() const {
  return static_cast<std::size_t>(frames_) == times_.size() ||
         std::ranges::all_of(simulations_, [](const physics::Simulation& simulation) {
           return simulation.trajectory().divergedAt.has_value();
         });
}

ClipMotion SceneSimulation::motion() const {
  std::vector<physics::Trajectory> trajectories;
  for (const physics::Simulation& simulation : simulations_) {
    trajectories.push_back(simulation.trajectory());
  }
  return {std::move(trajectories), rate_};
}

ClipMotion simulateScene(const scene::Scene& scene, const std::atomic<bool>* stop) {
  SceneSimulation simulation(scene);
  while (!simulation.isComplete() && !(stop != nullptr && *stop)) simulation.advance();
  return simulation.motion();
}

}  // namespace rotatebook::timeline
