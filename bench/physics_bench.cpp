// The cost of a step, by model and integrator, beside the same step in the plainest words, and
// beside that of many motions in lanes; and that of the exact solution. Single thread, default
// flags.
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "base/number_text.h"
#include "physics/make_simulator.h"
#include "physics/motion_start.h"
#include "plain_steps.h"
#include "rigid/exact_rotation.h"
#include "scene/names.h"
#include "study/lanes/ensemble.h"

namespace rotatebook::bench {
namespace {

using physics::Integrator;
using physics::Model;

constexpr double kStep = 1e-4;  // [s]
constexpr int kSteps = 1000;    // a measurement

MotionSettings tumbling(Model model, Integrator integrator) {
  MotionSettings settings;
  settings.simulation.model = model;
  settings.simulation.integrator = integrator;
  settings.simulation.stiffness = 125;
  settings.initial.value = {4, 0, 0};
  settings.initial.tilt = physics::Tilt{0.01, 2};
  return settings;
}

// Seconds for one step, which the table shows in nanoseconds.
void reportStep(benchmark::State& state, double steps = kSteps) {
  state.counters["step"] = benchmark::Counter(
      steps, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void step(benchmark::State& state, const MotionSettings& settings) {
  const auto simulator = makeSimulator(settings);
  for (auto _ : state) simulator->advance(kStep * kSteps, kSteps);
  benchmark::DoNotOptimize(simulator->state());
  reportStep(state);
}

template <typename Plain>
void plainStep(benchmark::State& state, Model model) {
  Plain plain(tumbling(model, Integrator::Euler));
  for (auto _ : state) {
    for (int i = 0; i < kSteps; ++i) plain.advance(kStep);
  }
  benchmark::DoNotOptimize(plain);
  reportStep(state);
}

// Motions of a map: the tilt varies.
std::vector<MotionSettings> motionsOf(Model model, Integrator integrator, double h, int substeps) {
  std::vector<MotionSettings> motions(64, tumbling(model, integrator));
  for (std::size_t i = 0; i < motions.size(); ++i) {
    motions[i].initial.tilt->angle = 0.01 * static_cast<double>(1 + i);
    motions[i].simulation.substeps = substeps;
    motions[i].simulation.timePerFrame = h * substeps;
  }
  return motions;
}

void lanes(benchmark::State& state, Model model, Integrator integrator,
           study::lanes::InstructionSet set) {
  constexpr int kMany = 10 * kSteps;
  const auto motions = motionsOf(model, integrator, kStep, kMany);
  for (auto _ : state) benchmark::DoNotOptimize(study::lanes::statesAfter(motions, 1, set));
  reportStep(state, kMany * static_cast<double>(motions.size()));
}

// A column of a map of half-turns: 20 s in steps of 3 ms, looked at every 51 ms.
void halfTurns(benchmark::State& state, study::lanes::InstructionSet set) {
  constexpr int kMany = 6667;
  std::vector<study::lanes::WatchedMotion> motions;
  for (const MotionSettings& motion : motionsOf(Model::Quaternion, Integrator::Euler, 0.003, 1)) {
    motions.push_back({motion, kMany, 17});
  }
  for (auto _ : state) {
    study::lanes::Ensemble ensemble(set);
    for (const auto& motion : motions) ensemble.add(motion);
    benchmark::DoNotOptimize(ensemble.finish());
  }
  reportStep(state, kMany * static_cast<double>(motions.size()));
}

void exactConstruction(benchmark::State& state, double tilt) {
  MotionSettings settings = tumbling(Model::Exact, Integrator::Euler);
  settings.initial.tilt->angle = tilt;
  const rigid::PrincipalAxes inertia = modelInertia(settings);
  const DoubleDouble3 velocity = settings.initial.alongPrincipal(inertia);
  for (auto _ : state) benchmark::DoNotOptimize(rigid::ExactRotation(inertia, velocity).at(10));
}

void exactEvaluation(benchmark::State& state, double tilt) {
  MotionSettings settings = tumbling(Model::Exact, Integrator::Euler);
  settings.initial.tilt->angle = tilt;
  const rigid::ExactRotation rotation(modelInertia(settings), initialAngularVelocity(settings));
  double time = 0;
  for (auto _ : state) {
    for (int i = 0; i < kSteps; ++i) benchmark::DoNotOptimize(rotation.at(time += 0.01));
  }
  reportStep(state);
}

void registerModels() {
  for (const auto& [modelName, model] : scene::kModels) {
    for (const auto& [name, integrator] : scene::kIntegrators) {
      if (!physics::isFor(model, integrator)) continue;
      benchmark::RegisterBenchmark((std::string(modelName) + "/" + std::string(name)).c_str(), step,
                                   tumbling(model, integrator));
    }
  }
}

void registerLanes() {
  for (const study::lanes::InstructionSet set : study::lanes::availableSets()) {
    if (set == study::lanes::InstructionSet::None) continue;
    const std::string name(nameOf(set));
    for (const Integrator integrator :
         {Integrator::Euler, Integrator::Rk4, Integrator::Midpoint, Integrator::Dmv6}) {
      const auto word = physics::kIntegratorNames.at(static_cast<std::size_t>(integrator));
      benchmark::RegisterBenchmark(("lanes/" + std::string(word) + "/" + name).c_str(), lanes,
                                   Model::Quaternion, integrator, set);
    }
    benchmark::RegisterBenchmark(("lanes/matrix/euler/" + name).c_str(), lanes, Model::Matrix,
                                 Integrator::Euler, set);
    benchmark::RegisterBenchmark(("lanes/half-turns/" + name).c_str(), halfTurns, set);
  }
}

void registerOthers() {
  benchmark::RegisterBenchmark("plain/particles/euler", plainStep<PlainParticles>,
                               Model::Particles);
  benchmark::RegisterBenchmark("plain/matrix/euler", plainStep<PlainMatrix>, Model::Matrix);
  benchmark::RegisterBenchmark("plain/quaternion/euler", plainStep<PlainQuaternion>,
                               Model::Quaternion);
  for (const double tilt : {0.5, 1e-2, 1e-6, 1e-12}) {
    benchmark::RegisterBenchmark(("exact, made anew/tilt " + shortestText(tilt)).c_str(),
                                 exactConstruction, tilt);
    benchmark::RegisterBenchmark(("exact/tilt " + shortestText(tilt)).c_str(), exactEvaluation,
                                 tilt);
  }
}

}  // namespace
}  // namespace rotatebook::bench

int main(int argc, char** argv) {
  rotatebook::bench::registerModels();
  rotatebook::bench::registerLanes();
  rotatebook::bench::registerOthers();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
