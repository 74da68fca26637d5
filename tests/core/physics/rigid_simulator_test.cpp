#include "physics/rigid_simulator.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "physics/integrators/rigid_state.h"
#include "physics/scenarios.h"

namespace rotatebook::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kSecondOrderBound = 0.01;  // of 2, the ratio of two errors; measured 0.0033
constexpr double kRigidBound = 1e-14;       // measured 0

// One second of a free body of one kilogram, 0.15 x 0.22 x 0.04 m, exact to all digits: the closed
// form by Jacobi's elliptic functions evaluated at 50 digits, confirmed by a Taylor integration of
// order 44.
struct Reference {
  Vector3d start;            // angular velocity [rad/s]
  Quaterniond attitude;      // after 1 s
  Vector3d angularVelocity;  // after 1 s, world axes
};

const Reference kGeneric{
    {1.1, -2.3, -3.7},
    {-0.42150592943285825, 0.10676603928786604, 0.08354512336009359, -0.8966348067471344},
    {-0.2159305229226537, -1.9781359957246276, -4.043906913116037}};
const Reference kAboutZ{
    {0.3140283820265676, 0, 6.275332961655438},
    {-0.9999820195078163, 0.0048428691485353495, -0.0033704246557908425, 0.0010712222547820539},
    {0.2961225921946916, -0.11736734355669154, 6.275964863145565}};

Sample afterOneSecond(Model model, const Reference& reference, int steps) {
  MotionSettings settings = spinning(model, reference.start, 1);
  settings.body = {{0.15, 0.22, 0.04}, 1};
  settings.simulation.substeps = steps;
  return simulate(settings, 2).samples.back();
}

double attitudeError(const Sample& sample, const Reference& reference) {
  return sample.attitude.angularDistance(reference.attitude);
}

double spinError(const Sample& sample, const Reference& reference) {
  return (sample.angularVelocity - reference.angularVelocity).norm();
}

class Convergence : public testing::TestWithParam<Model> {
 protected:
  // With a first-order integrator half the step makes half the error.
  void expectFirstOrder(const Reference& reference) {
    const Sample coarse = afterOneSecond(GetParam(), reference, 8000);
    const Sample fine = afterOneSecond(GetParam(), reference, 16000);
    const double attitudeRatio = attitudeError(coarse, reference) / attitudeError(fine, reference);
    const double spinRatio = spinError(coarse, reference) / spinError(fine, reference);
    EXPECT_NEAR(attitudeRatio, 2, kSecondOrderBound);
    EXPECT_NEAR(spinRatio, 2, kSecondOrderBound);
    EXPECT_LT(attitudeError(fine, reference), 1e-3);  // [rad]; measured 3.6e-4
  }
};

TEST_P(Convergence, IsOfFirstOrderOnAGenericSpin) {
  expectFirstOrder(kGeneric);
}

TEST_P(Convergence, IsOfFirstOrderAboutTheStableAxisZ) {
  expectFirstOrder(kAboutZ);
}

INSTANTIATE_TEST_SUITE_P(OfEuler, Convergence, testing::Values(Model::Matrix, Model::Quaternion),
                         [](const auto& instance) {
                           return instance.param == Model::Matrix ? "Matrix" : "Quaternion";
                         });

TEST(AngularVelocityInWorld, TurnsTheInertiaWithTheBody) {
  const Vector3d inertia(13, 10, 5);
  const RigidConstants body{inertia, inertia.cwiseInverse(), Vector3d::Zero()};
  Matrix3d worldFromBody;     // a quarter turn about z
  worldFromBody << 0, -1, 0,  //
      1, 0, 0,                //
      0, 0, 1;
  const Vector3d spin = angularVelocityInWorld(body, worldFromBody, {13, 20, 15});
  EXPECT_LT((spin - Vector3d(13.0 / 10, 20.0 / 13, 15.0 / 5)).norm(), kRigidBound);
}

}  // namespace
}  // namespace rotatebook::physics
