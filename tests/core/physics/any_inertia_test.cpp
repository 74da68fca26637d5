// Rigid bodies whose inertia is a tensor of their own.
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kInertiaBound = 1e-14;     // relative; measured 1.4e-15
constexpr double kSameMotionBound = 1e-13;  // [m]; measured 5.5e-16

Matrix3d principal() {
  return Vector3d(3, 4, 5).asDiagonal();
}

Matrix3d someRotation() {
  return AngleAxisd(0.7, Vector3d(2, -1, 2) / 3).toRotationMatrix();
}

class AnyInertia : public testing::TestWithParam<Model> {};

// Two descriptions of one body: along its principal axes, and turned within its own.
TEST_P(AnyInertia, MovesAsItDoesAlongItsPrincipalAxes) {
  MotionSettings straight = spinning(GetParam(), {1, 2, 3}, 0.5);
  straight.simulation.substeps = 500;
  straight.simulation.integrator = Integrator::Rk4;
  straight.inertia = principal();

  const Matrix3d turn = someRotation();
  MotionSettings turned = straight;
  turned.inertia = turn * principal() * turn.transpose();
  turned.initial.value = turn * straight.initial.value;

  const body::Cage corners = straight.body.corners();
  const Sample one = simulate(straight, 2).samples.back();
  const Sample two = simulate(turned, 2).samples.back();
  const Matrix3d expected = turn * one.attitude.toRotationMatrix() * turn.transpose();
  EXPECT_LT((two.cage - expected * corners).norm(), kSameMotionBound);
  EXPECT_LT((two.angularMomentum - turn * one.angularMomentum).norm(), 4 * kSameMotionBound);
  EXPECT_LT(two.errorDeg, 1e-6);  // measured 3e-10
  EXPECT_EQ(one.regime, two.regime);
  EXPECT_GT((two.cage - one.cage).norm(), 0.01) << "the tensor isn't looked at";
}

INSTANTIATE_TEST_SUITE_P(OfModel, AnyInertia,
                         testing::Values(Model::Matrix, Model::Quaternion, Model::Exact),
                         [](const auto& instance) {
                           return std::string(instance.param == Model::Matrix       ? "Matrix"
                                              : instance.param == Model::Quaternion ? "Quaternion"
                                                                                    : "Exact");
                         });

TEST(AnyInertia, GivesTheVelocityOfAMomentum) {
  MotionSettings settings = spinning(Model::Exact, {3, 8, 15}, 1);
  settings.initial.kind = InitialSpin::Kind::AngularMomentum;
  settings.inertia = principal();
  EXPECT_LT((initialAngularVelocity(settings) - Vector3d(1, 2, 3)).norm(), kInertiaBound);

  const Matrix3d tensor = someRotation() * principal() * someRotation().transpose();
  settings.inertia = tensor;
  settings.initial.value = tensor * Vector3d(1, 2, 3);
  EXPECT_LT((initialAngularVelocity(settings) - Vector3d(1, 2, 3)).norm(), 10 * kInertiaBound);
}

}  // namespace
}  // namespace rotatebook::physics
