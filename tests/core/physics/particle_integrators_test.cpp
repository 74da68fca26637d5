// The promises of the documentation of the particles' integrators: order, momentum, limits of the
// step.
#include <algorithm>
#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include "physics/integrator_names.h"
#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

constexpr double kOrderBound = 0.1;        // measured 0.051 (rk4)
constexpr double kRoundingDrift = 1e-13;   // relative, in 20,000 steps; measured 4.5e-15
constexpr double kRealDrift = 2e-11;       // no rounding; measured 1.0e-10 (rk4) and more
constexpr double kNormalisedDrift = 1e-3;  // measured 0.014 and more
constexpr double kDuration = 0.5;          // [s]

struct Case {
  Integrator integrator;
  int order;
  int coarseSteps;
};

void PrintTo(const Case& one, std::ostream* stream) {
  *stream << nameOf(one.integrator);
}

// Springs so soft that the book stretches visibly.
MotionSettings softBook(Integrator integrator, double damping) {
  MotionSettings settings = spinning(Model::Particles, {1.1, -2.3, -3.7}, kDuration);
  settings.simulation.integrator = integrator;
  settings.simulation.normalizeEvery = 0;
  settings.simulation.stiffness = 50;
  settings.simulation.damping = damping;
  return settings;
}

BodyState stateAfter(const MotionSettings& settings, int steps) {
  const auto simulator = makeSimulator(settings);
  simulator->advance(kDuration, steps);
  return simulator->state();
}

// Of places and speeds: the places alone of symplectic Euler are of order 2 where, as here, no
// spring pulls at the start. [m] plus [J]
double distance(const BodyState& a, const BodyState& b) {
  return (a.cage.value() - b.cage.value()).norm() + std::abs(a.kinetic - b.kinetic);
}

// Against Runge-Kutta with a step so short that its error is rounding.
double slopeOf(const Case& one, double damping) {
  const MotionSettings settings = softBook(one.integrator, damping);
  const BodyState truth = stateAfter(softBook(Integrator::Rk4, damping), 16000);
  const double coarse = distance(stateAfter(settings, one.coarseSteps), truth);
  const double fine = distance(stateAfter(settings, 2 * one.coarseSteps), truth);
  return std::log2(coarse / fine);
}

double momentumDriftOf(const MotionSettings& settings) {
  const auto simulator = makeSimulator(settings);
  const Eigen::Vector3d start = simulator->state().angularMomentum;
  simulator->advance(20, 20000);
  return (simulator->state().angularMomentum - start).norm() / start.norm();
}

class EachParticleIntegrator : public testing::TestWithParam<Case> {};

TEST_P(EachParticleIntegrator, HasItsOrderWithoutDamping) {
  EXPECT_NEAR(slopeOf(GetParam(), 0), GetParam().order, kOrderBound);
}

TEST_P(EachParticleIntegrator, HasItsOrderWithDamping) {
  EXPECT_NEAR(slopeOf(GetParam(), 0.5), GetParam().order, kOrderBound);
}

bool keepsMomentum(Integrator integrator) {
  return integrator == Integrator::SymplecticEuler || integrator == Integrator::Verlet;
}

TEST_P(EachParticleIntegrator, KeepsTheMomentumIfItSaysSo) {
  for (const double damping : {0.0, 0.5}) {
    const double drift = momentumDriftOf(softBook(GetParam().integrator, damping));
    if (keepsMomentum(GetParam().integrator)) {
      EXPECT_LT(drift, kRoundingDrift) << damping;
    } else {
      EXPECT_FALSE(drift < kRealDrift) << drift;
    }
  }
}

// Even those that keep it: the velocities are scaled to the energy, and the momentum with them.
TEST_P(EachParticleIntegrator, DoesNotKeepTheMomentumNormalised) {
  MotionSettings settings = softBook(GetParam().integrator, 0.5);
  settings.simulation.normalizeEvery = 1;
  const double drift = momentumDriftOf(settings);
  EXPECT_FALSE(drift < kNormalisedDrift) << drift;
}

constexpr Case kCases[]{{Integrator::Euler, 1, 16000},
                        {Integrator::SymplecticEuler, 1, 16000},
                        {Integrator::Verlet, 2, 2000},
                        {Integrator::Rk4, 4, 800}};

INSTANTIATE_TEST_SUITE_P(All, EachParticleIntegrator, testing::ValuesIn(kCases),
                         [](const auto& instance) { return nameOf(instance.param.integrator); });

struct Limit {
  Integrator integrator;
  double damping;
  double step;  ///< In units of sqrt(m/k).
};

void PrintTo(const Limit& limit, std::ostream* stream) {
  *stream << nameOf(limit.integrator) << " damping " << limit.damping;
}

// At the start the springs are at rest: the first step changes no velocity, and moves by them.
TEST(SymplecticEuler, PushesBeforeItMoves) {
  const auto simulator = makeSimulator(softBook(Integrator::SymplecticEuler, 0.5));
  const BodyState start = simulator->state();
  simulator->advance(kDuration, 1);
  const BodyState state = simulator->state();
  EXPECT_NEAR(state.kinetic, start.kinetic, kRoundingDrift * start.kinetic);
  EXPECT_GT(state.potential, start.kinetic);
}

class StepLimit : public testing::TestWithParam<Limit> {};

// Returns whether a book that hardly turns stays in one piece; every mode of the springs starts
// from rounding.
bool holdsTogether(const Limit& limit, double factor) {
  MotionSettings settings = softBook(limit.integrator, limit.damping);
  settings.initial.value = {0.01, 0.02, 0.03};
  const double mass = settings.body.mass / 8;
  const double h = factor * limit.step * std::sqrt(mass / settings.simulation.stiffness);
  const auto simulator = makeSimulator(settings);
  simulator->advance(10000 * h, 10000);
  const BodyState state = simulator->state();
  return state.potential < state.rotational;
}

TEST_P(StepLimit, IsWhereTheDocumentationSays) {
  EXPECT_TRUE(holdsTogether(GetParam(), 0.99));
  EXPECT_FALSE(holdsTogether(GetParam(), 1.01));
}

INSTANTIATE_TEST_SUITE_P(Each, StepLimit,
                         testing::Values(Limit{Integrator::Euler, 1, 0.12917},
                                         Limit{Integrator::SymplecticEuler, 1, 0.12132},
                                         Limit{Integrator::Verlet, 1, 0.125},
                                         Limit{Integrator::Rk4, 1, 0.17990},
                                         Limit{Integrator::SymplecticEuler, 0, 0.70711},
                                         Limit{Integrator::Verlet, 0, 0.70711},
                                         Limit{Integrator::Rk4, 0, 1}),
                         [](const auto& instance) {
                           return nameOf(instance.param.integrator) +
                                  (instance.param.damping > 0 ? "Damped" : "Undamped");
                         });

}  // namespace
}  // namespace rotatebook::physics
