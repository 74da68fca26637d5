#include "physics/integrators/integrator_table.h"

#include <algorithm>

#include "physics/integrators/explicit_euler.h"
#include "physics/integrators/explicit_gyroscopic.h"
#include "physics/integrators/implicit_gyroscopic.h"
#include "physics/integrators/lie_group.h"
#include "physics/integrators/midpoint.h"
#include "physics/integrators/moser_veselov.h"
#include "physics/integrators/no_gyroscopic.h"
#include "physics/integrators/particle_euler.h"
#include "physics/integrators/particle_runge_kutta.h"
#include "physics/integrators/renormalised.h"
#include "physics/integrators/runge_kutta.h"
#include "physics/integrators/splitting.h"
#include "physics/integrators/verlet.h"
#include "physics/integrators/vibration.h"
#include "physics/particle_simulator.h"
#include "physics/rigid_simulator.h"

namespace rotatebook::physics {
namespace {

constexpr std::array kRigid{Model::Matrix, Model::Quaternion};
constexpr std::array kParticles{Model::Particles};

template <typename Method>
AnyStep quaternionStepOf(const RigidConstants& body, double h) {
  return Method::stepOf(body, h);
}

template <typename Method>
AnyStep matrixStepOf(const RigidConstants& body, double h) {
  return Method::matrixStepOf(body, h);
}

template <RigidIntegrator Method>
constexpr Stepping rigid(std::string_view keeps, int nanoseconds, std::string_view source) {
  Stepping result{kRigid, keeps, nanoseconds, source, &makeRigidSimulator<Method>};
  if constexpr (requires(const RigidConstants& body) { Method::stepOf(body, 1.0); }) {
    result.quaternionStep = &quaternionStepOf<Method>;
  }
  if constexpr (requires(const RigidConstants& body) { Method::matrixStepOf(body, 1.0); }) {
    result.matrixStep = &matrixStepOf<Method>;
  }
  result.takesDissipation = requires {
    Method::kTakesDissipation;
  };
  return result;
}

template <ParticleIntegrator Method>
std::unique_ptr<Simulator> makeParticleSimulator(const MotionSettings& settings) {
  if (!areEight(settings.simulation.particles.arrangement))
    return std::make_unique<ManyParticleSimulator>(settings,
                                                   &Method::template step<ManyParticleState>);
  return std::make_unique<ParticleSimulator>(settings, &Method::template step<ParticleState>);
}

template <ParticleIntegrator Method>
constexpr Stepping particles(std::string_view keeps, int nanoseconds, std::string_view source) {
  Stepping result{kParticles, keeps, nanoseconds, source, &makeParticleSimulator<Method>};
  result.stableStep = &stableStepOf<Method>;
  return result;
}

constexpr std::array kTable{
#define ROTATEBOOK_INTEGRATOR(enumerator, word, order, ...) \
  IntegratorRow{Integrator::enumerator, word, order, {__VA_ARGS__}},
#include "physics/integrators/integrator_list.inc"
#undef ROTATEBOOK_INTEGRATOR
};

}  // namespace

std::span<const IntegratorRow> integratorTable() {
  return kTable;
}

const Stepping* steppingOf(Model model, Integrator integrator) {
  const auto& steppings = kTable.at(static_cast<std::size_t>(integrator)).steppings;
  const auto found = std::ranges::find_if(
      steppings, [&](const Stepping& one) { return std::ranges::count(one.models, model) > 0; });
  return found == steppings.end() ? nullptr : &*found;
}

bool isFor(Model model, Integrator integrator) {
  return steppingOf(model, integrator) != nullptr;
}

bool takesDissipation(Model model, Integrator integrator) {
  const Stepping* stepping = steppingOf(model, integrator);
  return stepping != nullptr && stepping->takesDissipation;
}

std::vector<Integrator> integratorsOf(Model model) {
  std::vector<Integrator> integrators;
  for (const IntegratorRow& row : kTable) {
    if (isFor(model, row.integrator)) integrators.push_back(row.integrator);
  }
  return integrators;
}

}  // namespace rotatebook::physics
