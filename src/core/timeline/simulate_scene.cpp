#include "timeline/simulate_scene.h"

#include <cstddef>
#include <utility>

#include "base/error.h"
#include "physics/integrators/step_error.h"

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
    : rate_(scene.clip.frameRate), times_(frameTimes(scene)), isGrid_(scene.grid.has_value()) {
  requireSameLayout();
  takeNames(scene);
  for (const scene::Panel& panel : scene.motions) {
    simulations_.push_back(
        named(names_[simulations_.size()], [&] { return physics::Simulation(panel.motion()); }));
  }
  refusedAt_.resize(simulations_.size());
}

void SceneSimulation::takeNames(const scene::Scene& scene) {
  names_.clear();
  for (const scene::Panel& panel : scene.motions) names_.push_back(nameOf(scene, panel));
}

void SceneSimulation::advance() {
  if (isComplete()) return;
  const double time = times_[static_cast<std::size_t>(frames_)];
  for (std::size_t i = 0; i < simulations_.size(); ++i) {
    if (refusedAt_[i]) continue;
    named(names_[i], [&] {
      try {
        simulations_[i].sample(time);
      } catch (const physics::StepError&) {
        if (!isGrid_) throw;
        refusedAt_[i] = time;
      }
    });
  }
  ++frames_;
}

bool SceneSimulation::isComplete() const {
  if (static_cast<std::size_t>(frames_) == times_.size()) return true;
  for (std::size_t i = 0; i < simulations_.size(); ++i) {
    if (!refusedAt_[i] && !simulations_[i].trajectory().divergedAt) return false;
  }
  return true;
}

ClipMotion SceneSimulation::motion() const {
  std::vector<physics::Trajectory> trajectories;
  for (std::size_t i = 0; i < simulations_.size(); ++i) {
    trajectories.push_back(simulations_[i].trajectory());
    if (refusedAt_[i]) trajectories.back().divergedAt = refusedAt_[i];
  }
  return {std::move(trajectories), rate_};
}

ClipMotion simulateScene(const scene::Scene& scene, const std::atomic<bool>* stop) {
  SceneSimulation simulation(scene);
  while (!simulation.isComplete() && !(stop != nullptr && *stop)) simulation.advance();
  return simulation.motion();
}

}  // namespace rotatebook::timeline
