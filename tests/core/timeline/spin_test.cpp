// The numbers of a spin: against values computed at 50 digits, and against simulated motions.
#include "timeline/spin.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "physics/simulate.h"
#include "scene/scene_text.h"
#include "timeline/euler_steps.h"

namespace rotatebook::timeline {
namespace {

using physics::MotionSettings;
using physics::Sample;
using rigid::Regime;
using std::numbers::pi;

MotionSettings motionOf(const Eigen::Vector3d& inertia, const Eigen::Vector3d& velocity) {
  MotionSettings settings;
  settings.inertia = inertia.asDiagonal();
  settings.initial.value = velocity;
  return settings;
}

MotionSettings bookWith(const std::string& initial) {
  return scene::parseScene("[initial]\n" + initial, "s.toml").motions[0];
}

/// Numbers of a motion, computed at 50 digits by the closed form and by a Taylor integration.
struct Known {
  const char* name;
  Eigen::Vector3d inertia, velocity;
  Regime regime;
  double period, halfPeriodTurn, twiceEnergy, momentum, invariant;
};

// clang-format off
const std::vector<Known> kKnown{
    {"x_tilt_z_1e-2", {0.004166666666666667, 0.0020083333333333333, 0.005908333333333333},
     {6.282871150532213, 0, 0.06283080587948064}, Regime::AboutLargest,
     6.2445971563891405, 18.6535391185633, 0.16450028228003097, 0.026181261737009895, 4.0623308355911675e-08},
    {"x_tilt_z_1e-6", {0.004166666666666667, 0.0020083333333333333, 0.005908333333333333},
     {6.283185307176445, 0, 6.283185307178539e-06}, Regime::AboutLargest,
     16.662171935751715, 51.38085286849496, 0.1644934066848914, 0.026179938779928174, 4.06246624932593e-16},
    {"y_tilt_z_5e-2", {0.004166666666666667, 0.0020083333333333333, 0.005908333333333333},
     {0, 6.275332961655438, 0.3140283820265676}, Regime::AboutSmallest,
     1.714847651763177, 5.40030501772105, 0.07967041593848559, 0.012738801398320862, -0.00016968300534449506},
    {"z_tilt_x_5e-2", {0.004166666666666667, 0.0020083333333333333, 0.005908333333333333},
     {0.3140283820265676, 0, 6.275332961655438}, Regime::AboutLargest,
     1.1110522449489793, 3.489188536277552, 0.23307989826769426, 0.037099839584795055, 0.00040523185443546654},
    {"generic_A", {0.004166666666666667, 0.0020083333333333333, 0.005908333333333333},
     {1.1, -2.3, -3.7}, Regime::AboutLargest,
     1.952444588853029, 3.9576487777836244, 0.09655083333333334, 0.02280876320993023, 0.00011794454027777778},
    {"hairer_vilmart", {0.6, 0.8, 1}, {3, 0.5, -0.9}, Regime::AboutSmallest,
     6.862616178058117, 11.184578178170462, 6.41, 2.0518284528683193, -0.918},
};
// clang-format on

TEST(Spin, AgreesWithFiftyDigits) {
  for (const Known& known : kKnown) {
    SCOPED_TRACE(known.name);
    const Spin spin = spinOf(motionOf(known.inertia, known.velocity));
    const double near = 1e-14;  // measured 5.6e-16
    ASSERT_TRUE(spin.period && spin.margin);
    EXPECT_EQ(spin.regime, known.regime);
    EXPECT_NEAR(spin.period->time / known.period, 1, near);
    EXPECT_NEAR(spin.period->turn / (2 * known.halfPeriodTurn), 1, near);
    EXPECT_NEAR(spin.period->dynamicTurn / (known.twiceEnergy * known.period / known.momentum), 1,
                near);
    EXPECT_NEAR(2 * spin.energy / known.twiceEnergy, 1, near);
    EXPECT_NEAR(spin.angularMomentum.norm() / known.momentum, 1, near);
    const double middle = spin.moments[1];
    EXPECT_NEAR(*spin.margin / (known.invariant / (known.twiceEnergy * middle)), 1, near);
  }
}

/// One period of a motion, measured from samples that Runge-Kutta 4 made.
struct Measured {
  double turn = 0;        ///< About L, of the axis about which w goes as cn.
  double axisTurn = 0;    ///< About L, of the axis that L circles.
  double solidAngle = 0;  ///< That L encloses in the body about that axis.
  double remainder = 0;   ///< |w(T) - w(0)| / |w(0)| in body axes.
};

/// Returns the turn of `axis`, in body axes, about L from one sample to the next.
double turnBetween(const Sample& a, const Sample& b, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d up = a.angularMomentum.normalized();
  const Eigen::Vector3d one = up.cross(a.attitude * axis), other = up.cross(b.attitude * axis);
  return std::atan2(up.dot(one.cross(other)), one.dot(other));
}

Eigen::Vector3d momentumInBody(const Sample& sample) {
  return (sample.attitude.conjugate() * sample.angularMomentum).normalized();
}

/// Returns the signed solid angle of a spherical triangle. (van Oosterom and Strackee 1983)
double solidAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

Measured measuredPeriod(MotionSettings settings, const Spin& spin) {
  constexpr int kFrames = 4000;
  settings.simulation.timePerFrame = spin.period->time / kFrames;
  settings.simulation.substepped.reset();
  settings.simulation.substeps = 8;
  const auto samples = physics::simulate(settings, kFrames + 1).samples;
  const bool aboutLargest = spin.regime == Regime::AboutLargest;
  Eigen::Vector3d circled = spin.axes[aboutLargest ? 2 : 0];
  const Eigen::Vector3d cosine = spin.axes[aboutLargest ? 0 : 2];
  if (circled.dot(spin.angularMomentum) < 0) circled = -circled;
  Measured measured;
  for (std::size_t n = 1; n < samples.size(); ++n) {
    measured.turn += turnBetween(samples[n - 1], samples[n], cosine);
    measured.axisTurn += turnBetween(samples[n - 1], samples[n], circled);
    measured.solidAngle +=
        solidAngle(circled, momentumInBody(samples[n - 1]), momentumInBody(samples[n]));
  }
  const auto inBody = [](const Sample& s) { return s.attitude.conjugate() * s.angularVelocity; };
  measured.remainder =
      (inBody(samples.back()) - inBody(samples.front())).norm() / spin.angularVelocity.norm();
  return measured;
}

class SimulatedSpin : public ::testing::TestWithParam<std::string> {};

// Polygons on the sphere are smaller than the curves that they follow.
TEST_P(SimulatedSpin, HasThePeriodAndTheTurns) {
  const MotionSettings settings = bookWith(GetParam());
  const Spin spin = spinOf(settings);
  ASSERT_TRUE(spin.period);
  const Measured measured = measuredPeriod(settings, spin);
  EXPECT_LT(measured.remainder, 1e-10);                                 // measured 1.2e-12
  EXPECT_NEAR(measured.turn, spin.period->turn, 1e-11);                 // measured 4.8e-13
  EXPECT_NEAR(measured.axisTurn, spin.period->axisTurn, 1e-11);         // measured 4.6e-13
  EXPECT_NEAR(-measured.solidAngle, spin.period->geometricTurn, 2e-6);  // measured 4.7e-7
  EXPECT_NEAR(spin.period->turn, spin.period->dynamicTurn + spin.period->geometricTurn, 1e-13);
  EXPECT_LT(std::fabs(spin.period->geometricTurn), 2 * pi);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, SimulatedSpin,
    ::testing::Values("angular_velocity = [5, 0, 0]\ntilt = ['1 deg', 'z']",
                      "angular_velocity = [5, 0, 0]\ntilt = ['1 deg', 'y']",
                      "angular_velocity = [-5, 0, 0]\ntilt = ['5 deg', 'y']",
                      "angular_velocity = [0, 5, 0]\ntilt = ['10 deg', 'z']",
                      "angular_velocity = [0, 0, -5]\ntilt = ['10 deg', 'x']",
                      "angular_velocity = [1.1, -2.3, -3.7]", "angular_velocity = [-3, 4, 1]",
                      "angular_momentum = [0.02, 0.03, 0.01]",
                      "angular_velocity = [3, 2, 1]\n[body]\n"
                      "inertia = [[3, 0.1, 0.2], [0.1, 4, 0.3], [0.2, 0.3, 5]]",
                      "angular_velocity = [3, 0.5, 4]\n[body]\nsize = [0.2, 0.2, 0.05]",
                      "angular_velocity = [3, 0.5, 4]\n[body]\nsize = [0.3, 0.1, 0.1]"));

TEST(Spin, GrowsAboutTheMiddleAxisAndCirclesTheOthers) {
  const Eigen::Vector3d inertia(3, 2, 4);
  const Spin middle = spinOf(motionOf(inertia, {5, 0, 0.01}));
  EXPECT_EQ(middle.spunAxis, 1U);
  EXPECT_NEAR(*middle.growth, std::sqrt(25.0001 / 8), 1e-15);
  EXPECT_FALSE(middle.oscillation);
  EXPECT_NEAR(middle.offAxis, 0.002, 1e-8);

  const Spin largest = spinOf(motionOf(inertia, {0, 0.001, 5}));
  EXPECT_EQ(largest.spunAxis, 2U);
  EXPECT_FALSE(largest.growth);
  EXPECT_NEAR(*largest.oscillation, 2 * pi / largest.period->time, 1e-6);
  EXPECT_FALSE(largest.flipInterval() || largest.firstFlip);

  const Spin smallest = spinOf(motionOf(inertia, {0.001, 5, 0}));
  EXPECT_EQ(smallest.spunAxis, 0U);
  EXPECT_NEAR(*smallest.oscillation, 2 * pi / smallest.period->time, 1e-6);
  EXPECT_FALSE(smallest.flipInterval());
}

TEST(Spin, FlipsTwiceInAPeriod) {
  const Spin spin = spinOf(bookWith("angular_velocity = [5, 0, 0]\ntilt = ['1 deg', 'z']"));
  EXPECT_EQ(*spin.flipInterval(), spin.period->time / 2);
  // Spun about z and y, too, but more about x: it flips, though L is far from the separatrix.
  EXPECT_TRUE(spinOf(motionOf({3, 2, 4}, {5, 1, 3})).flipInterval());
}

TEST(Spin, FlipsFirstWhenTheExactMotionDoes) {
  MotionSettings settings = bookWith("angular_velocity = [5, 0, 0]\ntilt = ['1 deg', 'z']");
  settings.simulation.model = physics::Model::Exact;
  const double first = spinOf(settings).firstFlip.value();
  constexpr double kBeside = 1e-9;  // [s]
  const std::vector<double> times{0, first - kBeside, first + kBeside};
  const auto trajectory = physics::simulate(settings, times);
  EXPECT_EQ(trajectory.samples[1].halfTurns, 0);
  EXPECT_EQ(trajectory.samples[2].halfTurns, 1);
}

// L circles another axis than the spun one, which never comes to the other side.
TEST(Spin, OfTwoAxesAlikeDoesNotFlip) {
  MotionSettings settings = bookWith("angular_velocity = [1.2, 6.6, 6.5]");
  settings.simulation.model = physics::Model::Exact;
  const Spin spin = spinOf(settings);
  EXPECT_TRUE(spin.period);
  EXPECT_FALSE(spin.flipInterval() || spin.firstFlip);
  std::vector<double> times(20 * 60);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i) / 60;
  EXPECT_EQ(physics::simulate(settings, times).samples.back().halfTurns, 0);
}

// The axis of a flat plate goes round twice while the plate turns once. (Feynman)
TEST(Spin, OfASymmetricBodyHasTheTextbooksPrecession) {
  const Spin flat = spinOf(motionOf({1, 1, 2}, {0.01, 0, 5}));
  EXPECT_EQ(flat.equal, EqualMoments::TwoSmallest);
  EXPECT_NEAR(flat.period->axisTurn / flat.period->time, flat.angularMomentum.norm(), 1e-13);
  EXPECT_NEAR(flat.period->axisTurn / flat.period->turn, 2, 1e-5);
  EXPECT_NEAR(*flat.oscillation, 2 * pi / flat.period->time, 1e-4);
  EXPECT_FALSE(flat.margin || flat.toSeparatrix || flat.growth || flat.flipInterval());

  const Spin tall = spinOf(motionOf({2, 2, 1}, {0.5, 0.3, 5}));
  EXPECT_EQ(tall.equal, EqualMoments::TwoLargest);
  EXPECT_NEAR(tall.period->axisTurn / tall.period->time, tall.angularMomentum.norm() / 2, 1e-13);
}

// Turning a body rounds its moments: [[1, 0.2], [0.2, 1]] beside 1.2, and a cylinder on its side.
TEST(Spin, TakesMomentsThatOnlyRoundingPartsForEqual) {
  const Spin tensor =
      spinOf(scene::parseScene("[body]\n"
                               "inertia = [[1, 0.2, 0], [0.2, 1, 0], [0, 0, 1.2]]\n"
                               "[initial]\nangular_velocity = { about = 'smallest', "
                               "value = 5 }",
                               "s.toml")
                 .motions[0]);
  EXPECT_EQ(tensor.equal, EqualMoments::TwoLargest);
  EXPECT_TRUE(tensor.isSteady);
  EXPECT_FALSE(tensor.margin || tensor.growth || tensor.period);
  const std::string cylinder =
      "[[body.part]]\nshape = 'cylinder'\nturn = ['33 deg', 'x']\n[initial]\n";
  const Spin named = spinOf(
      scene::parseScene(cylinder + "angular_velocity = { about = 'smallest', value = 5 }", "s.toml")
          .motions[0]);
  EXPECT_EQ(named.equal, EqualMoments::TwoLargest);
  EXPECT_TRUE(named.isSteady);
  const Spin tilted =
      spinOf(scene::parseScene(cylinder + "angular_velocity = { about = 'smallest', "
                                          "value = 5 }\ntilt = [0.01, 'x']",
                               "s.toml")
                 .motions[0]);
  EXPECT_FALSE(tilted.isSteady);
  EXPECT_NEAR(tilted.offAxis, 0.01, 1e-12);  // measured 1e-17 off
}

TEST(Spin, KeepsMomentsApartThatAreGivenApart) {
  EXPECT_EQ(spinOf(motionOf({2, 2 * (1 + 1e-11), 3}, {5, 0, 0.1})).equal, EqualMoments::None);
}

TEST(Spin, IsSteadyAboutAPrincipalAxis) {
  for (const Eigen::Vector3d& w : {Eigen::Vector3d(5, 0, 0), Eigen::Vector3d(0, 0, 5)}) {
    const Spin spin = spinOf(motionOf({3, 2, 4}, w));
    EXPECT_TRUE(spin.isSteady);
    EXPECT_FALSE(spin.period);
    EXPECT_EQ(spin.offAxis, 0);
  }
  EXPECT_EQ(*spinOf(motionOf({3, 2, 4}, {5, 0, 0})).margin, 0);
  const Spin sphere = spinOf(motionOf({3, 3, 3}, {1, 2, 3}));
  EXPECT_EQ(sphere.equal, EqualMoments::All);
  EXPECT_TRUE(sphere.isSteady);
  EXPECT_FALSE(sphere.growth || sphere.oscillation || sphere.period || sphere.margin);
  // Across the axis of a symmetric body.
  EXPECT_TRUE(spinOf(motionOf({3, 3, 4}, {1, 2, 0})).isSteady);
}

// I3 (I3 - I2) w3^2 = I1 (I2 - I1) w1^2, in whole numbers.
TEST(Spin, HasNoPeriodOnTheSeparatrix) {
  const MotionSettings settings = motionOf({4, 8, 9}, {3, 7, 4});
  const Spin spin = spinOf(settings);
  EXPECT_EQ(spin.regime, Regime::Separatrix);
  EXPECT_EQ(*spin.margin, 0);
  EXPECT_EQ(*spin.toSeparatrix, 0);
  EXPECT_FALSE(spin.period || spin.isSteady || spin.flipInterval());
  EXPECT_FALSE(eulerStepsFor(settings, 100));
}

// Beside the separatrix the angle is that to either of its planes.
TEST(Spin, KnowsItsDistanceToTheSeparatrix) {
  const Eigen::Vector3d inertia(2, 3, 4);
  const double angle = std::atan(std::sqrt(2.0 * 1 / (4 * 1)));  // of w3 / w1 on the separatrix
  for (const double beside : {0.1, -0.1, 1e-7, -1e-9}) {
    const Spin spin =
        spinOf(motionOf(inertia, {std::cos(angle + beside), 0, std::sin(angle + beside)}));
    EXPECT_NEAR(*spin.toSeparatrix / std::fabs(beside), 1, 3e-16 / std::fabs(beside) + 1e-13);
    EXPECT_EQ(*spin.margin > 0, beside > 0);
    EXPECT_EQ(spin.regime, beside > 0 ? Regime::AboutLargest : Regime::AboutSmallest);
  }
}

TEST(Spin, OfParticlesIsThatOfARigidBody) {
  MotionSettings settings = bookWith("angular_velocity = [5, 0, 0]\ntilt = ['1 deg', 'z']");
  const Spin rigid = spinOf(settings);
  settings.simulation.model = physics::Model::Particles;
  const Spin particles = spinOf(settings);
  EXPECT_NEAR(particles.moments[0] / rigid.moments[0], 3, 1e-14);
  EXPECT_NEAR(particles.period->time / rigid.period->time, 1, 1e-12);
}

/// Returns whether L stays about the axis of the start in every frame that Euler makes.
bool eulerKeepsTheRegime(MotionSettings settings, int substeps, std::int64_t frames) {
  settings.simulation.integrator = physics::Integrator::Euler;
  settings.simulation.substeps = substeps;
  const auto samples = physics::simulate(settings, frames).samples;
  return std::ranges::all_of(
      samples, [&](const Sample& sample) { return sample.regime == samples.front().regime; });
}

TEST(EulerSteps, AreTheFewestThatKeepTheRegime) {
  for (const std::string tilt : {"5 deg", "10 deg"}) {
    const MotionSettings settings =
        bookWith("angular_velocity = [5, 0, 0]\ntilt = ['" + tilt + "', 'z']");
    const auto needed = eulerStepsFor(settings, 240);
    ASSERT_TRUE(needed && needed->substeps);
    EXPECT_GT(*needed->substeps, 1);
    EXPECT_TRUE(eulerKeepsTheRegime(settings, *needed->substeps, 240));
    EXPECT_FALSE(eulerKeepsTheRegime(settings, *needed->substeps / 2, 240));
    EXPECT_EQ(needed->step, settings.simulation.timePerFrame / *needed->substeps);
  }
}

TEST(EulerSteps, AreBounded) {
  const auto needed =
      eulerStepsFor(bookWith("angular_velocity = [5, 0, 0]\ntilt = [1e-6, 'z']"), 100'000);
  ASSERT_TRUE(needed);
  EXPECT_FALSE(needed->substeps);
  EXPECT_EQ(needed->tried, 512);
}

TEST(EulerSteps, AreOfNoUseWithoutARegime) {
  EXPECT_FALSE(eulerStepsFor(bookWith("angular_velocity = [5, 0, 0]"), 100));
  EXPECT_FALSE(eulerStepsFor(motionOf({1, 1, 2}, {0.1, 0, 5}), 100));
  EXPECT_FALSE(eulerStepsFor(motionOf({1, 2, 2.5}, {0.1, 0, 5}), 1));
}

}  // namespace
}  // namespace rotatebook::timeline
