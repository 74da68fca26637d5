#include "scene/expectation.h"

#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/expectation_text.h"

namespace rotatebook::scene {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Samples at 0, 0.1 ... 0.4 s, of simple numbers.
physics::Trajectory example() {
  physics::Trajectory trajectory;
  trajectory.interval = 0.1;
  for (int n = 0; n < 5; ++n) {
    physics::Sample sample;
    sample.time = n * trajectory.interval;
    sample.tiltDeg = 10 * n;    // 0 10 20 30 40
    sample.kinetic = 3 + n;     // 3 4 5 6 7
    sample.potential = 1;       // energy ratio 1 1.25 1.5 1.75 2
    sample.rotational = 4 - n;  // rotational ratio 1 0.75 0.5 0.25 0
    sample.angularMomentum = Eigen::Vector3d(0, 3, 4) * (1 + n);  // momentum ratio 1 2 3 4 5
    sample.stretchMin = 1 - 0.1 * n;                              // 1 0.9 0.8 0.7 0.6
    sample.stretchMax = 1 + 0.2 * n;                              // 1 1.2 1.4 1.6 1.8
    sample.halfTurns = n / 2;                                     // 0 0 1 1 2
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

physics::Trajectory diverging() {
  physics::Trajectory trajectory = example();
  trajectory.divergedAt = 0.5;
  return trajectory;
}

ExpectationResult checkOne(const physics::Trajectory& trajectory, const Expectation& expectation) {
  return check(trajectory, {&expectation, 1}).front();
}

bool met(const physics::Trajectory& trajectory, const Expectation& expectation) {
  return checkOne(trajectory, expectation).met;
}

void expectRange(const Expectation& expectation, double lowest, double highest) {
  const ExpectationResult result = checkOne(example(), expectation);
  EXPECT_DOUBLE_EQ(result.lowest, lowest) << nameOf(expectation.quantity);
  EXPECT_DOUBLE_EQ(result.highest, highest) << nameOf(expectation.quantity);
}

TEST(Quantities, HaveTheNamesOfAScene) {
  std::vector<std::string_view> names;
  for (const Quantity quantity : allQuantities()) names.push_back(nameOf(quantity));
  EXPECT_THAT(names,
              ElementsAre("half_turns", "tilt_deg", "energy_ratio", "rotational_ratio", "L_ratio",
                          "stretch", "error_deg", "regime", "centre_drift", "diverges_at"));
}

TEST(Quantities, AreNamedEachByItsOwn) {
  EXPECT_EQ(nameOf(Quantity::HalfTurns), "half_turns");
  EXPECT_EQ(nameOf(Quantity::MomentumRatio), "L_ratio");
  EXPECT_EQ(nameOf(Quantity::DivergesAt), "diverges_at");
}

TEST(Check, MeasuresEachQuantityOverTheWholeMotion) {
  expectRange({.quantity = Quantity::HalfTurns}, 2, 2);
  expectRange({.quantity = Quantity::TiltDeg}, 0, 40);
  expectRange({.quantity = Quantity::EnergyRatio}, 1, 2);
  expectRange({.quantity = Quantity::RotationalRatio}, 0, 1);
  expectRange({.quantity = Quantity::MomentumRatio}, 1, 5);
  expectRange({.quantity = Quantity::Stretch}, 0.6, 1.8);
  expectRange({.quantity = Quantity::DivergesAt}, kInfinity, kInfinity);
}

TEST(Check, MeasuresEachQuantityWithinAWindow) {
  expectRange({.quantity = Quantity::HalfTurns, .from = 0.2, .to = 0.3}, 0, 0);
  expectRange({.quantity = Quantity::HalfTurns, .from = 0.1, .to = 0.3}, 1, 1);
  expectRange({.quantity = Quantity::TiltDeg, .from = 0.05, .to = 0.25}, 10, 20);
  expectRange({.quantity = Quantity::EnergyRatio, .from = 0.15, .to = 0.35}, 1.5, 1.75);
  expectRange({.quantity = Quantity::RotationalRatio, .from = 0.15, .to = 0.35}, 0.25, 0.5);
  expectRange({.quantity = Quantity::MomentumRatio, .to = 0.15}, 1, 2);
  expectRange({.quantity = Quantity::Stretch, .to = 0.15}, 0.9, 1.2);
}

// 3 * 0.1 is a little more than 0.3.
TEST(Check, CountsASampleOnTheEdgeOfItsWindow) {
  expectRange({.quantity = Quantity::TiltDeg, .from = 0.1, .to = 0.3}, 10, 30);
  expectRange({.quantity = Quantity::TiltDeg, .from = 0.3, .to = 0.3}, 30, 30);
  expectRange({.quantity = Quantity::TiltDeg, .from = 3 * 0.1, .to = 3 * 0.1}, 30, 30);
}

TEST(Check, MeetsEachBoundOrNot) {
  constexpr Quantity kTilt = Quantity::TiltDeg;
  const physics::Trajectory motion = example();
  EXPECT_TRUE(met(motion, {.quantity = kTilt, .min = 10, .from = 0.1}));
  EXPECT_FALSE(met(motion, {.quantity = kTilt, .min = 10.001, .from = 0.1}));
  EXPECT_TRUE(met(motion, {.quantity = kTilt, .max = 40}));
  EXPECT_FALSE(met(motion, {.quantity = kTilt, .max = 39.999}));
  EXPECT_TRUE(met(motion, {.quantity = kTilt, .risesTo = 40}));
  EXPECT_FALSE(met(motion, {.quantity = kTilt, .risesTo = 40.001}));
  EXPECT_TRUE(met(motion, {.quantity = kTilt, .fallsTo = 10, .from = 0.1}));
  EXPECT_FALSE(met(motion, {.quantity = kTilt, .fallsTo = 9.999, .from = 0.1}));
}

TEST(Check, NeedsAllBoundsOfOneExpectation) {
  constexpr Quantity kEnergy = Quantity::EnergyRatio;
  const physics::Trajectory motion = example();
  EXPECT_TRUE(met(motion, {.quantity = kEnergy, .min = 1, .max = 2, .risesTo = 2, .fallsTo = 1}));
  EXPECT_FALSE(
      met(motion, {.quantity = kEnergy, .min = 1.1, .max = 2, .risesTo = 2, .fallsTo = 1}));
  EXPECT_FALSE(
      met(motion, {.quantity = kEnergy, .min = 1, .max = 1.9, .risesTo = 2, .fallsTo = 1}));
  EXPECT_FALSE(
      met(motion, {.quantity = kEnergy, .min = 1, .max = 2, .risesTo = 2.1, .fallsTo = 1}));
  EXPECT_FALSE(
      met(motion, {.quantity = kEnergy, .min = 1, .max = 2, .risesTo = 2, .fallsTo = 0.9}));
}

TEST(Check, HoldsEverySingularValueToTheBoundsOfStretch) {
  const physics::Trajectory motion = example();
  EXPECT_TRUE(met(motion, {.quantity = Quantity::Stretch, .min = 0.59, .max = 1.81}));
  EXPECT_FALSE(met(motion, {.quantity = Quantity::Stretch, .min = 0.61}));
  EXPECT_FALSE(met(motion, {.quantity = Quantity::Stretch, .max = 1.79}));
}

TEST(Check, NeverMeetsAnythingInAnEmptyWindow) {
  for (const Quantity quantity : allQuantities()) {
    for (const auto& [from, to] :
         {std::pair(0.11, 0.19), std::pair(5.0, 6.0), std::pair(0.3, 0.1)}) {
      const Expectation expectation{.quantity = quantity, .min = -1e9, .from = from, .to = to};
      const ExpectationResult result = checkOne(diverging(), expectation);
      EXPECT_TRUE(std::isnan(result.lowest)) << nameOf(quantity) << from;
      EXPECT_TRUE(std::isnan(result.highest)) << nameOf(quantity) << from;
      EXPECT_FALSE(result.met) << nameOf(quantity) << from;
      EXPECT_FALSE(met(diverging(), {.quantity = quantity, .from = from, .to = to}));
    }
  }
}

TEST(Check, ComparesTheMomentOfDivergence) {
  constexpr Quantity kAt = Quantity::DivergesAt;
  EXPECT_TRUE(met(diverging(), {.quantity = kAt, .min = 0.4, .max = 0.6}));
  EXPECT_FALSE(met(diverging(), {.quantity = kAt, .min = 0.51}));
  EXPECT_FALSE(met(diverging(), {.quantity = kAt, .max = 0.49}));
  EXPECT_FALSE(met(diverging(), {.quantity = kAt, .risesTo = 0.51}));
  EXPECT_FALSE(met(diverging(), {.quantity = kAt, .fallsTo = 0.49}));
  EXPECT_EQ(checkOne(diverging(), {.quantity = kAt}).lowest, 0.5);
}

TEST(Check, NeverMeetsAMomentOfDivergenceThatDoesNotCome) {
  constexpr Quantity kAt = Quantity::DivergesAt;
  EXPECT_FALSE(met(example(), {.quantity = kAt, .min = 0.1}));
  EXPECT_FALSE(met(example(), {.quantity = kAt, .max = 0.1}));
  EXPECT_FALSE(met(example(), {.quantity = kAt, .max = kInfinity}));
  EXPECT_FALSE(met(example(), {.quantity = kAt, .risesTo = 0.1}));
  EXPECT_FALSE(met(example(), {.quantity = kAt, .fallsTo = 0.1}));
}

TEST(Check, DoesNotTakeAMotionsEndForKeepingWithinBounds) {
  constexpr Quantity kTilt = Quantity::TiltDeg;
  EXPECT_FALSE(met(diverging(), {.quantity = kTilt, .max = 100}));
  EXPECT_FALSE(met(diverging(), {.quantity = kTilt, .min = -1}));
  EXPECT_FALSE(met(diverging(), {.quantity = kTilt, .max = 100, .to = 0.5}));
  EXPECT_TRUE(met(diverging(), {.quantity = kTilt, .max = 100, .to = 0.4}));
  EXPECT_TRUE(met(diverging(), {.quantity = kTilt, .risesTo = 40, .fallsTo = 0}));
  EXPECT_FALSE(met(diverging(), {.quantity = Quantity::HalfTurns, .min = 2, .max = 2}));
  EXPECT_TRUE(met(diverging(), {.quantity = Quantity::HalfTurns, .max = 2, .to = 0.4}));
}

// The last of five frames, 0.1 s apart, lasts until 0.5 s.
TEST(Check, NeedsAClipAsLongAsTheWindow) {
  for (const Quantity quantity : {Quantity::TiltDeg, Quantity::HalfTurns}) {
    EXPECT_TRUE(met(example(), {.quantity = quantity, .max = 100, .to = 0.5}));
    const ExpectationResult result =
        checkOne(example(), {.quantity = quantity, .max = 100, .to = 0.6});
    EXPECT_FALSE(result.met);
    EXPECT_THAT(measuredText(result), HasSubstr(", but the motion ends at 0.5 s"));
    EXPECT_TRUE(met(example(), {.quantity = quantity, .risesTo = 2, .to = 0.6}));
  }
}

TEST(Check, AnswersInTheOrderOfTheQuestions) {
  const std::vector<Expectation> expectations{{.quantity = Quantity::TiltDeg, .max = 1},
                                              {.quantity = Quantity::HalfTurns, .min = 1}};
  const auto results = check(example(), expectations);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].expectation, expectations[0]);
  EXPECT_FALSE(results[0].met);
  EXPECT_EQ(results[1].expectation, expectations[1]);
  EXPECT_TRUE(results[1].met);
}

}  // namespace
}  // namespace rotatebook::scene
