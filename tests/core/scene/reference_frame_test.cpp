#include "scene/reference_frame.h"

#include <gtest/gtest.h>

#include "physics/simulate.h"
#include "rigid/rotation.h"

namespace rotatebook::scene {
namespace {

physics::Sample tumblingSample() {
  physics::MotionSettings settings;
  settings.initial.value = {6, 0.5, 1};
  return physics::simulate(settings, 40).samples.back();
}

constexpr double kFrameBound = 1e-13;  // measured 1e-15

TEST(ReferenceFrame, OfTheWorldChangesNothing) {
  const physics::Sample sample = tumblingSample();
  EXPECT_EQ(inReferenceFrame(ReferenceFrame::World, sample).cage, sample.cage);
  EXPECT_EQ(frameFromWorld(ReferenceFrame::World, sample), Eigen::Matrix3d::Identity());
}

TEST(ReferenceFrame, OfTheBodyHoldsItStill) {
  const physics::Sample sample = tumblingSample(),
                        seen = inReferenceFrame(ReferenceFrame::Body, sample);
  EXPECT_GT(sample.attitude.angularDistance(Eigen::Quaterniond::Identity()), 1);
  EXPECT_LT(seen.attitude.angularDistance(Eigen::Quaterniond::Identity()), 1e-7);
  EXPECT_LT((seen.cage - physics::Cuboid().corners()).cwiseAbs().maxCoeff(),
            1e-3);  // Euler's drift
  EXPECT_LT((seen.angularVelocity - sample.attitude.conjugate() * sample.angularVelocity).norm(),
            1e-12);
}

TEST(ReferenceFrame, OfTheMomentumHasItUpright) {
  const physics::Sample sample = tumblingSample(),
                        seen = inReferenceFrame(ReferenceFrame::Momentum, sample);
  const double size = sample.angularMomentum.norm();
  EXPECT_GT((sample.angularMomentum - size * Eigen::Vector3d::UnitY()).norm(), size / 2);
  EXPECT_LT((seen.angularMomentum - size * Eigen::Vector3d::UnitY()).norm(), kFrameBound * size);
}

TEST(ReferenceFrame, TurnsAllVectorsAlike) {
  const physics::Sample sample = tumblingSample();
  for (const auto frame : {ReferenceFrame::Body, ReferenceFrame::Momentum}) {
    const Eigen::Matrix3d turn = frameFromWorld(frame, sample);
    EXPECT_LT((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), kFrameBound);
    EXPECT_NEAR(turn.determinant(), 1, kFrameBound);
    const physics::Sample seen = inReferenceFrame(frame, sample);
    EXPECT_NEAR(seen.angularVelocity.dot(seen.angularMomentum),
                sample.angularVelocity.dot(sample.angularMomentum), kFrameBound);
    EXPECT_LT((seen.attitude * physics::Cuboid().corners().col(7) -
               turn * (sample.attitude * physics::Cuboid().corners().col(7)))
                  .norm(),
              kFrameBound);
    EXPECT_EQ(seen.kinetic, sample.kinetic);
  }
}

TEST(ReferenceFrame, OfNoMomentumOrOneThatPointsDownIsARotation) {
  physics::Sample sample;
  EXPECT_EQ(frameFromWorld(ReferenceFrame::Momentum, sample), Eigen::Matrix3d::Identity());
  for (const double slant : {0.0, 1e-9, 1e-5}) {
    sample.angularMomentum = {slant, -2, 0};
    const Eigen::Matrix3d turn = frameFromWorld(ReferenceFrame::Momentum, sample);
    EXPECT_NEAR(turn.determinant(), 1, 1e-5) << slant;
    EXPECT_LT((turn * sample.angularMomentum - Eigen::Vector3d(0, 2, 0)).norm(), 1e-5) << slant;
  }
}

}  // namespace
}  // namespace rotatebook::scene
