// Motions in lanes are bit by bit those of the simulators, whatever the processor's vectors.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "physics/simulate.h"
#include "study/lanes/ensemble.h"
#include "study/random_motions.h"

namespace rotatebook::study::lanes {
namespace {

using physics::BodyState;
using physics::Integrator;
using physics::Model;
using physics::MotionSettings;
using ::testing::ElementsAre;
using testing::hardMotions;
using testing::ordinaryMotions;

struct Way {
  Integrator integrator;
  Model model = Model::Quaternion;

  std::string name() const {
    const auto word = physics::kIntegratorNames.at(static_cast<std::size_t>(integrator));
    return (model == Model::Matrix ? "matrix by " : "") + std::string(word);
  }
};

constexpr std::array kInLanes{Way{Integrator::Euler},
                              Way{Integrator::Rk4},
                              Way{Integrator::Midpoint},
                              Way{Integrator::Dmv2},
                              Way{Integrator::Dmv4},
                              Way{Integrator::Dmv6},
                              Way{Integrator::Euler, Model::Matrix}};

std::vector<MotionSettings> with(Model model, std::vector<MotionSettings> motions) {
  for (MotionSettings& motion : motions) motion.simulation.model = model;
  return motions;
}

using Bits = std::vector<std::uint64_t>;

// All NaN are taken for one: which of them it is, processors decide.
Bits bitsOf(const BodyState& state) {
  std::vector<double> numbers(state.worldFromBody.data(), state.worldFromBody.data() + 9);
  numbers.insert(numbers.end(), state.angularVelocity.begin(), state.angularVelocity.end());
  numbers.insert(numbers.end(), state.angularMomentum.begin(), state.angularMomentum.end());
  numbers.insert(numbers.end(), {state.kinetic, state.rotational});
  Bits bits;
  for (const double number : numbers) {
    bits.push_back(number != number ? 0 : std::bit_cast<std::uint64_t>(number));
  }
  return bits;
}

bool isFinite(const BodyState& state) {
  return state.worldFromBody.allFinite() && state.angularMomentum.allFinite();
}

struct Comparison {
  std::size_t different = 0, notFinite = 0;
};

Comparison compare(const std::vector<MotionSettings>& motions, const std::vector<BodyState>& scalar,
                   std::int64_t frames, InstructionSet set) {
  const auto lanes = statesAfter(motions, frames, set);
  Comparison result;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    result.notFinite += isFinite(scalar[i]) ? 0 : 1;
    result.different += bitsOf(scalar[i]) == bitsOf(lanes[i]) ? 0 : 1;
  }
  return result;
}

/// Motions, and what the simulators make of them.
struct Simulated {
  std::vector<MotionSettings> motions;
  std::vector<BodyState> states;

  Simulated(std::vector<MotionSettings> settings, std::int64_t frames)
      : motions(std::move(settings)), states(statesAfter(motions, frames, InstructionSet::None)) {}
};

/// Makes the motions of each integrator in lanes once, for all instruction sets.
std::vector<Simulated> simulated(
    const std::function<std::vector<MotionSettings>(Integrator)>& motions, std::int64_t frames) {
  std::vector<Simulated> all;
  for (const Way& way : kInLanes)
    all.emplace_back(with(way.model, motions(way.integrator)), frames);
  return all;
}

class Lanes : public ::testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    if (!isAvailable(GetParam())) GTEST_SKIP() << "not this processor's: " << nameOf(GetParam());
  }
};

TEST_P(Lanes, MakeTheStepsOfTheSimulators) {
  constexpr std::int64_t kFrames = 2000;
  static const auto kOrdinary =
      simulated([](Integrator of) { return ordinaryMotions(3072, of, 1); }, kFrames);
  for (std::size_t i = 0; i < kInLanes.size(); ++i) {
    const auto& [motions, states] = kOrdinary[i];
    const Comparison result = compare(motions, states, kFrames, GetParam());
    EXPECT_EQ(result.different, 0U) << kInLanes[i].name();
    EXPECT_EQ(result.notFinite, 0U);
  }
}

TEST_P(Lanes, MakeTheStepsThatBlowUpOrHaveNoSolution) {
  constexpr std::int64_t kFrames = 300;
  static const auto kHard =
      simulated([](Integrator of) { return hardMotions(3072, of, 2); }, kFrames);
  std::size_t notFinite = 0;
  for (std::size_t i = 0; i < kInLanes.size(); ++i) {
    const auto& [motions, states] = kHard[i];
    const Comparison result = compare(motions, states, kFrames, GetParam());
    EXPECT_EQ(result.different, 0U) << kInLanes[i].name();
    std::cout << kInLanes[i].name() << ": " << result.notFinite << " not finite\n";
    notFinite += result.notFinite;
  }
  EXPECT_GT(notFinite, 1000U);  // measured 2817
}

TEST_P(Lanes, NormalizeAsOftenWithSubsteps) {
  for (const Model model : {Model::Quaternion, Model::Matrix}) {
    auto motions = with(model, ordinaryMotions(200, Integrator::Euler, 3));
    for (std::size_t i = 0; i < motions.size(); ++i) {
      motions[i].simulation.substeps = 1 + static_cast<int>(i % 3);
      motions[i].simulation.normalizeEvery = static_cast<int>(i / 3 % 6);
    }
    const Simulated scalar(motions, 500);
    EXPECT_EQ(compare(motions, scalar.states, 500, GetParam()).different, 0U);
  }
}

// Spins about one of two axes and a tilt toward the other leave no momentum along the third, y for
// one in three of them; here for all, with tilts of either sign down to nearly none.
std::vector<MotionSettings> flatMotions(std::size_t count, std::uint64_t seed) {
  testing::Random random(seed);
  std::vector<MotionSettings> motions;
  while (motions.size() < count) {
    const double h = random.scaleBetween(16e-6, 0.3);
    const double tilt = random.scaleBetween(1e-40, 1) * (random.unit() < 0.5 ? -1 : 1);
    motions.push_back(testing::randomMotion(random, Integrator::Euler, h, 0));
    const double spin = random.between(1, 12) * (random.unit() < 0.5 ? -1 : 1);
    const bool isAlongX = random.unit() < 0.5;
    motions.back().initial.value = {isAlongX ? spin : tilt, 0, isAlongX ? tilt : spin};
    motions.back().simulation.normalizeEvery = random.below(3);
  }
  return motions;
}

TEST_P(Lanes, MakeStepsOfAMomentumWithoutAPartAlongY) {
  const auto motions = flatMotions(3072, 10);
  for (const std::int64_t frames : {1, 2, 3, 400}) {
    const Simulated scalar(motions, frames);
    EXPECT_EQ(compare(motions, scalar.states, frames, GetParam()).different, 0U) << frames;
  }
}

// Where all of a block turn little in a step, or all turn far, they are normalised by shorter ways.
TEST_P(Lanes, MakeStepsOfMotionsThatTurnAlike) {
  auto motions = ordinaryMotions(3072, Integrator::Euler, 12);
  std::ranges::sort(motions, {}, [](const MotionSettings& motion) {
    return motion.simulation.timePerFrame * motion.initial.value.norm();
  });
  const Simulated scalar(motions, 1000);
  EXPECT_EQ(compare(motions, scalar.states, 1000, GetParam()).different, 0U);
}

// Reduces what samples at the looks say.
Outcome expectedOf(const WatchedMotion& watched) {
  Outcome result;
  physics::Simulation simulation(watched.motion);
  const std::vector<physics::Sample>& samples = simulation.trajectory().samples;
  try {
    for (std::int64_t frame = 0; frame < watched.frames;) {
      frame = std::min(frame + watched.framesPerLook, watched.frames);
      const double time = static_cast<double>(frame) * watched.motion.simulation.timePerFrame;
      if (!simulation.sample(time)) break;
      if (samples.back().halfTurns > 0 && !result.firstTurn) result.firstTurn = time;
    }
  } catch (const InputError&) {
    result.isRefused = true;
  }
  result.halfTurns = samples.back().halfTurns;
  result.divergedAt = simulation.trajectory().divergedAt;
  return result;
}

std::vector<Outcome> outcomesOf(const std::vector<WatchedMotion>& motions, InstructionSet set) {
  Ensemble ensemble(set);
  for (const WatchedMotion& motion : motions) ensemble.add(motion);
  return ensemble.finish();
}

struct Seen {
  int halfTurns = 0, turned = 0, diverged = 0, refused = 0;
};

Seen compareOutcomes(const std::vector<WatchedMotion>& motions, InstructionSet set) {
  const std::vector<Outcome> outcomes = outcomesOf(motions, set);
  Seen seen;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Outcome expected = expectedOf(motions[i]);
    EXPECT_EQ(outcomes[i].halfTurns, expected.halfTurns) << i;
    EXPECT_EQ(outcomes[i].firstTurn, expected.firstTurn) << i;
    EXPECT_EQ(outcomes[i].divergedAt, expected.divergedAt) << i;
    EXPECT_EQ(outcomes[i].isRefused, expected.isRefused) << i;
    seen.halfTurns += expected.halfTurns;
    seen.turned += expected.firstTurn ? 1 : 0;
    seen.diverged += expected.divergedAt ? 1 : 0;
    seen.refused += expected.isRefused ? 1 : 0;
  }
  std::cout << seen.halfTurns << " half-turns of " << seen.turned << " motions, " << seen.diverged
            << " diverged, " << seen.refused << " refused\n";
  return seen;
}

// Of all integrators that have lanes and one that has none; with looks after each frame, after each
// third, and after more than there are in a row.
std::vector<WatchedMotion> mixed(const std::vector<MotionSettings>& motions, std::int64_t frames) {
  constexpr std::array<std::int64_t, 3> kFramesPerLook{1, 3, 7};
  std::vector<WatchedMotion> result;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const std::size_t kind = i / 16 % (kInLanes.size() + 1);
    const Way way = kind < kInLanes.size() ? kInLanes.at(kind) : Way{Integrator::Splitting};
    result.push_back({motions[i], frames, kFramesPerLook.at(i / 128 % kFramesPerLook.size())});
    result.back().motion.simulation.integrator = way.integrator;
    result.back().motion.simulation.model = way.model;
  }
  return result;
}

TEST_P(Lanes, CountWhatTheSamplesCount) {
  auto motions = mixed(ordinaryMotions(384, Integrator::Euler, 4), 400);
  for (WatchedMotion& watched : motions) {
    watched.motion.simulation.substeps = 4;
    watched.motion.simulation.timePerFrame = 1.0 / 60;
  }
  const Seen seen = compareOutcomes(motions, GetParam());
  EXPECT_GT(seen.halfTurns, 100);
  EXPECT_GT(seen.turned, 50);
}

TEST_P(Lanes, CountWhatDivergesAndFails) {
  const Seen seen = compareOutcomes(mixed(hardMotions(768, Integrator::Euler, 5), 150), GetParam());
  EXPECT_GT(seen.diverged, 10);
  EXPECT_GT(seen.refused, 30);
}

// Between two normalisations long steps flatten a matrix so much that rounding may mirror the body.
TEST_P(Lanes, CountWhereAMatrixMirrorsTheBody) {
  constexpr std::int64_t kFrames = 80, kFramesPerLook = 5;
  auto motions = with(Model::Matrix, ordinaryMotions(200, Integrator::Euler, 9));
  std::vector<WatchedMotion> watched;
  for (MotionSettings& motion : motions) {
    motion.simulation.normalizeEvery = kFramesPerLook;
    motion.simulation.timePerFrame = 0.5;
    watched.push_back({motion, kFrames, kFramesPerLook});
  }
  compareOutcomes(watched, GetParam());
  const auto mirrored = std::ranges::count_if(
      Simulated(motions, kFrames).states,
      [](const BodyState& state) { return state.worldFromBody.determinant() < 0; });
  EXPECT_GT(mirrored, 10);  // measured 61
}

// Long steps drive bodies into a spin about their long axis, after which nothing is counted: those
// of a block, which are much alike, at about the same time.
TEST_P(Lanes, CountUntilTheBodiesHaveSettled) {
  const auto motions = ordinaryMotions(16, Integrator::Euler, 11);
  std::vector<WatchedMotion> watched;
  for (std::size_t i = 0; i < 512; ++i) {
    watched.push_back({motions[i / 32], 1500, 3});
    MotionSettings& motion = watched.back().motion;
    motion.initial.value *= 1 + 1e-4 * static_cast<double>(i % 32);
    motion.simulation.timePerFrame = 0.005 * static_cast<double>(1 + i / 64);
  }
  const Seen seen = compareOutcomes(watched, GetParam());
  EXPECT_GT(seen.halfTurns, 600);  // measured 722
}

TEST_P(Lanes, RefuseAMotionThatThereIsnt) {
  std::vector<WatchedMotion> motions = mixed(ordinaryMotions(2, Integrator::Rk4, 8), 10);
  motions[0].motion.initial.value.setConstant(1e308);
  const std::vector<Outcome> outcomes = outcomesOf(motions, GetParam());
  EXPECT_TRUE(outcomes[0].isRefused);
  EXPECT_FALSE(outcomes[1].isRefused);
}

TEST_P(Lanes, LeaveNoMotionOut) {
  const auto motions = ordinaryMotions(37, Integrator::Rk4, 6);
  const Simulated scalar(motions, 50);
  EXPECT_EQ(compare(motions, scalar.states, 50, GetParam()).different, 0U);
  EXPECT_TRUE(outcomesOf({}, GetParam()).empty());
}

// Motions differ, so a lane in another's place would be noticed; and a step more.
TEST_P(Lanes, WouldShowADifference) {
  const auto motions = ordinaryMotions(64, Integrator::Euler, 7);
  const auto states = statesAfter(motions, 10, GetParam());
  const auto later = statesAfter(motions, 11, GetParam());
  EXPECT_NE(bitsOf(states[0]), bitsOf(states[1]));
  EXPECT_NE(bitsOf(states[0]), bitsOf(later[0]));
}

INSTANTIATE_TEST_SUITE_P(Of, Lanes,
                         ::testing::Values(InstructionSet::Base, InstructionSet::Avx2,
                                           InstructionSet::Avx512),
                         [](const auto& instance) {
                           std::string name(nameOf(instance.param));
                           std::erase(name, '-');
                           return name;
                         });

TEST(InstructionSets, StartWithOneMotionAtATime) {
  const auto sets = availableSets();
  ASSERT_GE(sets.size(), 2U);
  EXPECT_EQ(sets[0], InstructionSet::None);
  EXPECT_EQ(sets[1], InstructionSet::Base);
  EXPECT_EQ(widestSet(), sets.back());
}

}  // namespace
}  // namespace rotatebook::study::lanes
