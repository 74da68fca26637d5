#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "physics/make_simulator.h"
#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kStepBound = 1e-14;        // measured 1.2e-15
constexpr double kMatrixBound = 1e-14;      // measured 6e-16
constexpr double kEnergyDriftBound = 1e-4;  // relative; measured 2.1e-6
constexpr double kStretchBound = 1e-15;     // measured 0

using Rows = std::array<std::array<double, 3>, 3>;

// w = R I^-1 R^T L and R += h [w]x R, index by index.
void stepByHand(Rows& r, const std::array<double, 3>& inertia, const std::array<double, 3>& l,
                double h) {
  std::array<double, 3> w{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) w[i] += r[i][k] / inertia[k] * r[j][k] * l[j];
    }
  }
  const Rows old = r;
  for (std::size_t k = 0; k < 3; ++k) {
    r[0][k] += h * (w[1] * old[2][k] - w[2] * old[1][k]);
    r[1][k] += h * (w[2] * old[0][k] - w[0] * old[2][k]);
    r[2][k] += h * (w[0] * old[1][k] - w[1] * old[0][k]);
  }
}

Matrix3d asMatrix(const Rows& rows) {
  Matrix3d result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
  }
  return result;
}

// Inertia (13, 10, 5), spin (1, 2, 3), hence angular momentum (13, 20, 15).
MotionSettings byHand(bool normalize) {
  MotionSettings settings = spinning(Model::Matrix, {1, 2, 3}, 0.1);
  settings.body = {{1, 2, 3}, 12};
  settings.simulation.normalizeEvery = normalize ? 1 : 0;
  return settings;
}

TEST(MatrixSimulator, StepsAsByHand) {
  const auto simulator = makeSimulator(byHand(false));
  Rows expected{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int step = 0; step < 3; ++step) {
    simulator->advance(0.1, 1);
    stepByHand(expected, {13, 10, 5}, {13, 20, 15}, 0.1);
    EXPECT_LT((simulator->state().worldFromBody - asMatrix(expected)).norm(), kStepBound);
  }
}

TEST(MatrixSimulator, TakesTheFirstStepOfLiteralNumbers) {
  const auto simulator = makeSimulator(byHand(false));
  simulator->advance(0.1, 1);
  Matrix3d expected;
  expected << 1, -0.3, 0.2,  //
      0.3, 1, -0.1,          //
      -0.2, 0.1, 1;
  EXPECT_LT((simulator->state().worldFromBody - expected).norm(), kStepBound);
}

TEST(MatrixSimulator, NormalisesToTheNearestOrthogonalMatrix) {
  const auto simulator = makeSimulator(byHand(true));
  Rows expected{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  stepByHand(expected, {13, 10, 5}, {13, 20, 15}, 0.1);
  const Eigen::JacobiSVD<Matrix3d> svd(asMatrix(expected),
                                       Eigen::ComputeFullU | Eigen::ComputeFullV);
  simulator->advance(0.1, 1);
  EXPECT_LT((simulator->state().worldFromBody - svd.matrixU() * svd.matrixV().transpose()).norm(),
            kStepBound);
}

TEST(MatrixSimulator, StaysOrthogonalForManySteps) {
  MotionSettings settings = spinning(Model::Matrix, {6, 0.1, 0.2}, 1e-3);
  const auto simulator = makeSimulator(settings);
  for (int step = 0; step < 20000; ++step) simulator->advance(1e-3, 1);
  const Matrix3d map = simulator->state().worldFromBody;
  EXPECT_LT((map.transpose() * map - Matrix3d::Identity()).norm(), kMatrixBound);
}

TEST(MatrixSimulator, LengthensAcrossTheSpinWithoutNormalisation) {
  MotionSettings settings = spinning(Model::Matrix, {0, 0, 5}, 0.01);
  settings.simulation.normalizeEvery = 0;
  const auto simulator = makeSimulator(settings);
  simulator->advance(0.01, 1);
  const Matrix3d map = simulator->state().worldFromBody;
  EXPECT_NEAR(map.col(0).norm(), std::sqrt(1 + 0.05 * 0.05), kStretchBound);
  EXPECT_NEAR(map.col(2).norm(), 1, kStretchBound);
}

TEST(MatrixSimulator, ReportsTheEnergyAndMomentumOfTheSolidBody) {
  const BodyState state = makeSimulator(byHand(true))->state();
  EXPECT_LT((state.angularMomentum - Vector3d(13, 20, 15)).norm(), kStepBound);
  EXPECT_LT((state.angularVelocity - Vector3d(1, 2, 3)).norm(), kStepBound);
  EXPECT_NEAR(state.kinetic, 49, 10 * kStepBound);  // (13 + 40 + 45) / 2
  EXPECT_EQ(state.rotational, state.kinetic);
  EXPECT_EQ(state.potential, 0);
}

// Normalised Euler gains (h/2) a.I a of energy a second, a = I^-1 (L x w) in the body frame,
// however stable the motion.
TEST(MatrixSimulator, GainsEnergyAsExplicitEulerMust) {
  constexpr double kStep = 1e-5;
  const MotionSettings settings = spinning(Model::Matrix, {1.1, -2.3, -3.7}, kStep);
  const Vector3d inertia = settings.body.solidInertia();
  const auto simulator = makeSimulator(settings);
  const double start = simulator->state().kinetic;
  double predicted = 0;
  for (int step = 0; step < 20000; ++step) {
    const BodyState state = simulator->state();
    const Matrix3d fromBody = state.worldFromBody;
    const Vector3d w = fromBody.transpose() * state.angularVelocity;
    const Vector3d torque = inertia.cwiseProduct(w).cross(w);
    predicted += kStep * kStep / 2 * torque.dot(torque.cwiseQuotient(inertia));
    simulator->advance(kStep, 1);
  }
  EXPECT_NEAR((simulator->state().kinetic - start) / predicted, 1, kEnergyDriftBound);
}

}  // namespace
}  // namespace rotatebook::physics
