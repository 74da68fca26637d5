#include <string>

#include <gtest/gtest.h>

#include "physics/simulate.h"
#include "scene/shipped_scene.h"
#include "timeline/judge.h"
#include "timeline/simulate_scene.h"

namespace rotatebook::timeline {
namespace {

using physics::Integrator;
using physics::Model;

/// The verdict on the table of engines' motion by an integrator, one step a frame for 10 s.
Verdict verdictOn(Integrator integrator, int substeps = 1) {
  physics::MotionSettings motion;
  motion.body.size = {0.15, 0.22, 0.04};
  motion.initial.value = {6.283185307179586, 0, 0};
  motion.initial.tilt = {0.01, 2};
  motion.simulation.integrator = integrator;
  motion.simulation.substeps = substeps;
  return judge(motion, physics::simulate(motion, 601));
}

TEST(Verdict, NamesTheKindOfMethod) {
  EXPECT_EQ(verdictOn(Integrator::Rk4, 16).errs, Errs::Hardly);
  EXPECT_EQ(verdictOn(Integrator::NoGyroscopic).errs, Errs::SpinIsFixed);
  EXPECT_EQ(verdictOn(Integrator::Midpoint).errs, Errs::InPhase);
  EXPECT_EQ(verdictOn(Integrator::Euler).errs, Errs::GainsEnergy);
  EXPECT_EQ(verdictOn(Integrator::ExplicitGyroscopic).errs, Errs::GainsBoth);
  EXPECT_EQ(verdictOn(Integrator::ImplicitGyroscopic).errs, Errs::LosesBoth);
}

TEST(Verdict, MeasuresWhatTheMotionMakesOfIt) {
  const Verdict verdict = verdictOn(Integrator::ExplicitGyroscopic);
  EXPECT_EQ(verdict.samples, 601U);
  EXPECT_NEAR(verdict.duration, 10, 1e-12);
  EXPECT_EQ(verdict.halfTurns, 3);
  EXPECT_EQ(verdict.halfTurnsDue, 3);
  EXPECT_NEAR(verdict.endEnergyDrift, 0.475, 0.001);
  EXPECT_NEAR(verdict.endMomentumDrift, 0.2146, 0.001);
  EXPECT_NEAR(verdict.endErrorDeg, 26.9, 0.5);
  EXPECT_GT(verdict.errorDeg, 170);
  EXPECT_NEAR(*verdict.visibleFrom, 2, 0.2);
}

TEST(Verdict, CountsTheHalfTurnsThatAreDue) {
  const Verdict verdict = verdictOn(Integrator::NoGyroscopic);
  EXPECT_EQ(verdict.halfTurns, 0);
  EXPECT_EQ(verdict.halfTurnsDue, 3);
  EXPECT_NEAR(verdict.energyDrift, 0, 1e-3);
}

TEST(Verdict, TellsTheShippedEnginesApart) {
  const scene::Scene scene = scene::shippedScene("comparisons/recorded-engines");
  const ClipMotion motion = simulateScene(scene);
  const Errs expected[] = {Errs::Hardly,    Errs::SpinIsFixed, Errs::Inconsistently,
                           Errs::GainsBoth, Errs::Hardly,      Errs::Hardly};
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    EXPECT_EQ(judge(scene.motions[i].motion(), motion.trajectories()[i]).errs, expected[i])
        << scene.motions[i].label;
  }
}

TEST(Verdict, HasASentenceForEachKind) {
  Verdict verdict;
  for (int i = 0; i <= static_cast<int>(Errs::Inconsistently); ++i) {
    verdict.errs = static_cast<Errs>(i);
    EXPECT_FALSE(methodThat(verdict).empty()) << i;
  }
}

}  // namespace
}  // namespace rotatebook::timeline
