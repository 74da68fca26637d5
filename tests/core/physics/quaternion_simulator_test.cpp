#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "physics/make_simulator.h"
#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kQuaternionStepBound = 1e-13;  // measured 3e-15
constexpr double kUnitNormBound = 1e-14;        // measured 0
constexpr double kNormGrowthBound = 1e-12;      // measured 6e-14

using Quadruple = std::array<double, 4>;  // w, x, y, z
using AxisRoles = std::array<double, 3>;

// (1 - 2 |u|^2) v + 2 (u.v) u + 2 w (u x v), which is A(q) v in other words.
AxisRoles turned(const Quadruple& q, const AxisRoles& v) {
  const auto [w, x, y, z] = q;
  const double scale = 1 - 2 * (x * x + y * y + z * z);
  const double along = 2 * (x * v[0] + y * v[1] + z * v[2]);
  return {scale * v[0] + along * x + 2 * w * (y * v[2] - z * v[1]),
          scale * v[1] + along * y + 2 * w * (z * v[0] - x * v[2]),
          scale * v[2] + along * z + 2 * w * (x * v[1] - y * v[0])};
}

// q += h/2 (0, w) q with w = A(q) I^-1 A(conj q) L.
void stepByHand(Quadruple& q, const AxisRoles& inertia, const AxisRoles& l, double h) {
  AxisRoles spin = turned({q[0], -q[1], -q[2], -q[3]}, l);
  for (std::size_t i = 0; i < 3; ++i) spin[i] /= inertia[i];
  const auto [a, b, c] = turned(q, spin);
  const auto [w, x, y, z] = q;
  q[0] -= h / 2 * (a * x + b * y + c * z);
  q[1] += h / 2 * (a * w + b * z - c * y);
  q[2] += h / 2 * (b * w + c * x - a * z);
  q[3] += h / 2 * (c * w + a * y - b * x);
}

double norm(const Quadruple& q) {
  return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

// Inertia (13, 10, 5), spin (1, 2, 3), hence angular momentum (13, 20, 15).
MotionSettings quaternionByHand(int normalizeEvery) {
  MotionSettings settings = spinning(Model::Quaternion, {1, 2, 3}, 0.1);
  settings.body = {{1, 2, 3}, 12};
  settings.simulation.normalizeEvery = normalizeEvery;
  return settings;
}

double distance(const BodyState& state, const Quadruple& q, const body::Cuboid& body) {
  const body::Cage start = body.corners();
  body::Cage expected;
  for (int i = 0; i < 8; ++i) {
    const AxisRoles corner = turned(q, {start(0, i), start(1, i), start(2, i)});
    expected.col(i) = Vector3d(corner[0], corner[1], corner[2]);
  }
  return (drawnCage(state, body) - expected).norm();
}

void compareWithStepsByHand(int normalizeEvery) {
  const MotionSettings settings = quaternionByHand(normalizeEvery);
  const auto simulator = makeSimulator(settings);
  Quadruple expected{1, 0, 0, 0};
  for (int step = 1; step <= 5; ++step) {
    simulator->advance(0.1, 1);
    stepByHand(expected, {13, 10, 5}, {13, 20, 15}, 0.1);
    const bool isDue = normalizeEvery > 0 && step % normalizeEvery == 0;
    const double divisor = isDue ? norm(expected) : 1;
    for (double& part : expected) part /= divisor;
    EXPECT_LT(distance(simulator->state(), expected, settings.body), kQuaternionStepBound) << step;
  }
}

// |q|^2 from A(q): its trace is 3 - 4 |u|^2, its antisymmetric part 2 w u, where q = (w, u).
double squaredNorm(const BodyState& state) {
  const Matrix3d& map = state.worldFromBody;
  const double vectorPart = (3 - map.trace()) / 4;
  const Vector3d twist(map(2, 1) - map(1, 2), map(0, 2) - map(2, 0), map(1, 0) - map(0, 1));
  return vectorPart + twist.squaredNorm() / 16 / vectorPart;
}

TEST(QuaternionSimulator, StepsAsByHand) {
  compareWithStepsByHand(0);
}

TEST(QuaternionSimulator, DividesByTheNormIfNormalised) {
  compareWithStepsByHand(1);
}

// The steps are counted from the start, not from the last frame.
TEST(QuaternionSimulator, IsNormalisedAfterEachSecondStep) {
  compareWithStepsByHand(2);
}

TEST(QuaternionSimulator, TakesTheFirstStepOfLiteralNumbers) {
  const MotionSettings settings = quaternionByHand(0);
  const auto simulator = makeSimulator(settings);
  simulator->advance(0.1, 1);
  const Quadruple expected{1, 0.05, 0.1, 0.15};
  EXPECT_LT(distance(simulator->state(), expected, settings.body), kQuaternionStepBound);
}

TEST(QuaternionSimulator, KeepsUnitNorm) {
  const MotionSettings settings = spinning(Model::Quaternion, {6, 0.1, 0.2}, 1e-3);
  const auto simulator = makeSimulator(settings);
  for (int step = 0; step < 20000; ++step) simulator->advance(1e-3, 1);
  EXPECT_NEAR(squaredNorm(simulator->state()), 1, kUnitNormBound);
}

TEST(QuaternionSimulator, GrowsInNormAsExplicitEulerMust) {
  MotionSettings settings = spinning(Model::Quaternion, {1, 2, 3}, 0.02);
  settings.simulation.normalizeEvery = 0;
  const auto simulator = makeSimulator(settings);
  simulator->advance(0.02, 1);
  for (int step = 0; step < 10; ++step) {
    const BodyState before = simulator->state();
    simulator->advance(0.02, 1);
    const double halfAngle = 0.02 * before.angularVelocity.norm() / 2;
    const double growth = squaredNorm(simulator->state()) / squaredNorm(before);
    EXPECT_NEAR(growth, 1 + halfAngle * halfAngle, kNormGrowthBound);
  }
}

TEST(QuaternionSimulator, ReportsTheEnergyAndMomentumOfTheSolidBody) {
  const BodyState state = makeSimulator(quaternionByHand(1))->state();
  EXPECT_LT((state.angularMomentum - Vector3d(13, 20, 15)).norm(), kQuaternionStepBound);
  EXPECT_LT((state.angularVelocity - Vector3d(1, 2, 3)).norm(), kQuaternionStepBound);
  EXPECT_NEAR(state.kinetic, 49, kQuaternionStepBound);  // (13 + 40 + 45) / 2
  EXPECT_EQ(state.rotational, state.kinetic);
  EXPECT_EQ(state.potential, 0);
}

}  // namespace
}  // namespace rotatebook::physics
