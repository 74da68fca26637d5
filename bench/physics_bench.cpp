// The cost of a step, by model and integrator, beside the same step in the plainest words; and that
// of one evaluation of the exact solution. Single thread, default flags.
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "base/number_text.h"
#include "physics/make_simulator.h"
#include "physics/motion_start.h"
#include "plain_steps.h"
#include "rigid/exact_rotation.h"
#include "scene/names.h"

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
void reportStep(benchmark::State& state) {
  state.counters["step"] = benchmark::Counter(
      kSteps, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
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

void registerOthers() {
  benchmark::RegisterBenchmark("plain/particles/euler", plainStep<PlainParticles>,
                               Model::Particles);
  benchmark::RegisterBenchmark("plain/matrix/euler", plainStep<PlainMatrix>, Model::Matrix);
  benchmark::RegisterBenchmark("plain/quaternion/euler", plainStep<PlainQuaternion>,
                               Model::Quaternion);
  for (const double tilt : {0.5, 1e-2, 1e-6, 1e-12}) {
    benchmark::RegisterBenchmark(("exact/tilt " + shortestText(tilt)).c_str(), exactEvaluation,
                                 tilt);
  }
}

}  // namespace
}  // namespace rotatebook::bench

int main(int argc, char** argv) {
  rotatebook::bench::registerModels();
  rotatebook::bench::registerOthers();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
