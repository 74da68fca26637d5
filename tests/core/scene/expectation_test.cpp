#include "scene/expectation.h"

#include <cmath>
#include <limits>
#include <map>
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
  EXPECT_DOUBLE_EQ(result.lowest, lowest) << nameOf(expectation.measure);
  EXPECT_DOUBLE_EQ(result.highest, highest) << nameOf(expectation.measure);
}

TEST(Measures, HaveTheNamesOfAScene) {
  std::vector<std::string_view> names;
  for (const Measure measure : kMeasuresOfMotions) names.push_back(nameOf(measure));
  EXPECT_THAT(names,
              ElementsAre("half_turns", "tilt_deg", "energy_ratio", "rotational_ratio", "L_ratio",
                          "stretch", "error_deg", "regime", "centre_drift", "diverges_at"));
}

TEST(Measures, HaveAValueAtEachMomentUnlessTheyAreOfAWholeMotion) {
  physics::Trajectory motion = example();
  motion.samples[0].angularVelocity = Eigen::Vector3d(1, 0, 0);
  for (const MeasureRow& row : kMeasureRows) {
    const double value = valueOn(motion.samples[2], motion.samples[0], row.measure);
    EXPECT_EQ(std::isnan(value), row.span == MeasureSpan::Motion) << row.name;
  }
}

TEST(Measures, ShowNoOtherQuantity) {
  // Each is one number here; two measures with the same number would be one that shows another.
  physics::Trajectory motion = example();
  physics::Sample& sample = motion.samples[2];
  sample.rotational = 1;
  sample.errorDeg = 7;
  sample.regime = rigid::Regime::AboutSmallest;
  sample.cage = Eigen::Matrix<double, 3, 8>::Constant(0.125);  // its centre drifts by 0.2165
  sample.attitude = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ());
  motion.samples[0].angularVelocity = Eigen::Vector3d(1, 0, 0);
  std::map<double, std::string_view> names;
  for (const MeasureRow& row : kMeasureRows) {
    if (row.span == MeasureSpan::Motion) continue;
    const double value = valueOn(sample, motion.samples[0], row.measure);
    const auto [other, isNew] = names.emplace(value, row.name);
    EXPECT_TRUE(isNew) << row.name << " and " << other->second << " are " << value;
  }
}

TEST(Measures, StandInTheirRows) {
  for (std::size_t i = 0; i < kMeasureRows.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kMeasureRows[i].measure), i);
    EXPECT_FALSE(kMeasureRows[i].studied.empty());
    EXPECT_EQ(kMeasureRows[i].label.empty(), kMeasureRows[i].sections == MeasureSections::Studies);
  }
}

TEST(Quantities, AreNamedEachByItsOwn) {
  EXPECT_EQ(nameOf(Measure::HalfTurns), "half_turns");
  EXPECT_EQ(nameOf(Measure::MomentumRatio), "L_ratio");
  EXPECT_EQ(nameOf(Measure::DivergesAt), "diverges_at");
}

TEST(Check, MeasuresEachQuantityOverTheWholeMotion) {
  expectRange({.measure = Measure::HalfTurns}, 2, 2);
  expectRange({.measure = Measure::TiltDeg}, 0, 40);
  expectRange({.measure = Measure::EnergyRatio}, 1, 2);
  expectRange({.measure = Measure::RotationalRatio}, 0, 1);
  expectRange({.measure = Measure::MomentumRatio}, 1, 5);
  expectRange({.measure = Measure::Stretch}, 0.6, 1.8);
  expectRange({.measure = Measure::DivergesAt}, kInfinity, kInfinity);
}

TEST(Check, MeasuresEachQuantityWithinAWindow) {
  expectRange({.measure = Measure::HalfTurns, .from = 0.2, .to = 0.3}, 0, 0);
  expectRange({.measure = Measure::HalfTurns, .from = 0.1, .to = 0.3}, 1, 1);
  expectRange({.measure = Measure::TiltDeg, .from = 0.05, .to = 0.25}, 10, 20);
  expectRange({.measure = Measure::EnergyRatio, .from = 0.15, .to = 0.35}, 1.5, 1.75);
  expectRange({.measure = Measure::RotationalRatio, .from = 0.15, .to = 0.35}, 0.25, 0.5);
  expectRange({.measure = Measure::MomentumRatio, .to = 0.15}, 1, 2);
  expectRange({.measure = Measure::Stretch, .to = 0.15}, 0.9, 1.2);
}

// 3 * 0.1 is a little more than 0.3.
TEST(Check, CountsASampleOnTheEdgeOfItsWindow) {
  expectRange({.measure = Measure::TiltDeg, .from = 0.1, .to = 0.3}, 10, 30);
  expectRange({.measure = Measure::TiltDeg, .from = 0.3, .to = 0.3}, 30, 30);
  expectRange({.measure = Measure::TiltDeg, .from = 3 * 0.1, .to = 3 * 0.1}, 30, 30);
}

TEST(Check, MeetsEachBoundOrNot) {
  constexpr Measure kTilt = Measure::TiltDeg;
  const physics::Trajectory motion = example();
  EXPECT_TRUE(met(motion, {.measure = kTilt, .min = 10, .from = 0.1}));
  EXPECT_FALSE(met(motion, {.measure = kTilt, .min = 10.001, .from = 0.1}));
  EXPECT_TRUE(met(motion, {.measure = kTilt, .max = 40}));
  EXPECT_FALSE(met(motion, {.measure = kTilt, .max = 39.999}));
  EXPECT_TRUE(met(motion, {.measure = kTilt, .risesTo = 40}));
  EXPECT_FALSE(met(motion, {.measure = kTilt, .risesTo = 40.001}));
  EXPECT_TRUE(met(motion, {.measure = kTilt, .fallsTo = 10, .from = 0.1}));
  EXPECT_FALSE(met(motion, {.measure = kTilt, .fallsTo = 9.999, .from = 0.1}));
}

TEST(Check, NeedsAllBoundsOfOneExpectation) {
  constexpr Measure kEnergy = Measure::EnergyRatio;
  const physics::Trajectory motion = example();
  EXPECT_TRUE(met(motion, {.measure = kEnergy, .min = 1, .max = 2, .risesTo = 2, .fallsTo = 1}));
  EXPECT_FALSE(met(motion, {.measure = kEnergy, .min = 1.1, .max = 2, .risesTo = 2, .fallsTo = 1}));
  EXPECT_FALSE(met(motion, {.measure = kEnergy, .min = 1, .max = 1.9, .risesTo = 2, .fallsTo = 1}));
  EXPECT_FALSE(met(motion, {.measure = kEnergy, .min = 1, .max = 2, .risesTo = 2.1, .fallsTo = 1}));
  EXPECT_FALSE(met(motion, {.measure = kEnergy, .min = 1, .max = 2, .risesTo = 2, .fallsTo = 0.9}));
}

TEST(Check, HoldsEverySingularValueToTheBoundsOfStretch) {
  const physics::Trajectory motion = example();
  EXPECT_TRUE(met(motion, {.measure = Measure::Stretch, .min = 0.59, .max = 1.81}));
  EXPECT_FALSE(met(motion, {.measure = Measure::Stretch, .min = 0.61}));
  EXPECT_FALSE(met(motion, {.measure = Measure::Stretch, .max = 1.79}));
}

TEST(Check, NeverMeetsAnythingInAnEmptyWindow) {
  for (const Measure measure : kMeasuresOfMotions) {
    for (const auto& [from, to] :
         {std::pair(0.11, 0.19), std::pair(5.0, 6.0), std::pair(0.3, 0.1)}) {
      const Expectation expectation{.measure = measure, .min = -1e9, .from = from, .to = to};
      const ExpectationResult result = checkOne(diverging(), expectation);
      EXPECT_TRUE(std::isnan(result.lowest)) << nameOf(measure) << from;
      EXPECT_TRUE(std::isnan(result.highest)) << nameOf(measure) << from;
      EXPECT_FALSE(result.met) << nameOf(measure) << from;
      EXPECT_FALSE(met(diverging(), {.measure = measure, .from = from, .to = to}));
    }
  }
}

TEST(Check, ComparesTheMomentOfDivergence) {
  constexpr Measure kAt = Measure::DivergesAt;
  EXPECT_TRUE(met(diverging(), {.measure = kAt, .min = 0.4, .max = 0.6}));
  EXPECT_FALSE(met(diverging(), {.measure = kAt, .min = 0.51}));
  EXPECT_FALSE(met(diverging(), {.measure = kAt, .max = 0.49}));
  EXPECT_FALSE(met(diverging(), {.measure = kAt, .risesTo = 0.51}));
  EXPECT_FALSE(met(diverging(), {.measure = kAt, .fallsTo = 0.49}));
  EXPECT_EQ(checkOne(diverging(), {.measure = kAt}).lowest, 0.5);
}

TEST(Check, NeverMeetsAMomentOfDivergenceThatDoesNotCome) {
  constexpr Measure kAt = Measure::DivergesAt;
  EXPECT_FALSE(met(example(), {.measure = kAt, .min = 0.1}));
  EXPECT_FALSE(met(example(), {.measure = kAt, .max = 0.1}));
  EXPECT_FALSE(met(example(), {.measure = kAt, .max = kInfinity}));
  EXPECT_FALSE(met(example(), {.measure = kAt, .risesTo = 0.1}));
  EXPECT_FALSE(met(example(), {.measure = kAt, .fallsTo = 0.1}));
}

TEST(Check, DoesNotTakeAMotionsEndForKeepingWithinBounds) {
  constexpr Measure kTilt = Measure::TiltDeg;
  EXPECT_FALSE(met(diverging(), {.measure = kTilt, .max = 100}));
  EXPECT_FALSE(met(diverging(), {.measure = kTilt, .min = -1}));
  EXPECT_FALSE(met(diverging(), {.measure = kTilt, .max = 100, .to = 0.5}));
  EXPECT_TRUE(met(diverging(), {.measure = kTilt, .max = 100, .to = 0.4}));
  EXPECT_TRUE(met(diverging(), {.measure = kTilt, .risesTo = 40, .fallsTo = 0}));
  EXPECT_FALSE(met(diverging(), {.measure = Measure::HalfTurns, .min = 2, .max = 2}));
  EXPECT_TRUE(met(diverging(), {.measure = Measure::HalfTurns, .max = 2, .to = 0.4}));
}

// The last of five frames, 0.1 s apart, lasts until 0.5 s.
TEST(Check, NeedsAClipAsLongAsTheWindow) {
  for (const Measure measure : {Measure::TiltDeg, Measure::HalfTurns}) {
    EXPECT_TRUE(met(example(), {.measure = measure, .max = 100, .to = 0.5}));
    const ExpectationResult result =
        checkOne(example(), {.measure = measure, .max = 100, .to = 0.6});
    EXPECT_FALSE(result.met);
    EXPECT_THAT(measuredText(result), HasSubstr(", but the motion ends at 0.5 s"));
    EXPECT_TRUE(met(example(), {.measure = measure, .risesTo = 2, .to = 0.6}));
  }
}

TEST(Check, AnswersInTheOrderOfTheQuestions) {
  const std::vector<Expectation> expectations{{.measure = Measure::TiltDeg, .max = 1},
                                              {.measure = Measure::HalfTurns, .min = 1}};
  const auto results = check(example(), expectations);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].expectation, expectations[0]);
  EXPECT_FALSE(results[0].met);
  EXPECT_EQ(results[1].expectation, expectations[1]);
  EXPECT_TRUE(results[1].met);
}

}  // namespace
}  // namespace rotatebook::scene
