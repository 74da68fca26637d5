#include "physics/make_simulator.h"

#include "base/error.h"
#include "base/layout.h"
#include "physics/exact_simulator.h"
#include "physics/integrators/integrator_table.h"
#include "physics/recorded_simulator.h"

namespace rotatebook::physics {

std::unique_ptr<Simulator> makeSimulator(const MotionSettings& settings) {
  requireSameLayout();
  if (settings.simulation.model == Model::Exact) return std::make_unique<ExactSimulator>(settings);
  if (settings.simulation.model == Model::Recorded) {
    return std::make_unique<RecordedSimulator>(settings);
  }
  const Stepping* stepping = steppingOf(settings.simulation.model, settings.simulation.integrator);
  if (stepping == nullptr) throw InputError("this model doesn't have this integrator");
  if (settings.simulation.dissipates() && !stepping->takesDissipation) {
    throw InputError("this integrator takes no dissipation");
  }
  return stepping->make(settings);
}

}  // namespace rotatebook::physics
