#include "scene/reference_frame.h"

#include <algorithm>
#include <cmath>

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
  EXPECT_EQ(MotionFrame(ReferenceFrame::World).seen(sample).cage, sample.cage);
  EXPECT_EQ(MotionFrame(ReferenceFrame::World).fromWorld(sample), Eigen::Matrix3d::Identity());
}

TEST(ReferenceFrame, OfTheBodyHoldsItStill) {
  const physics::Sample sample = tumblingSample(),
                        seen = MotionFrame(ReferenceFrame::Body).seen(sample);
  EXPECT_GT(sample.attitude.angularDistance(Eigen::Quaterniond::Identity()), 1);
  EXPECT_LT(seen.attitude.angularDistance(Eigen::Quaterniond::Identity()), 1e-7);
  EXPECT_LT((seen.cage - body::Cuboid().corners()).cwiseAbs().maxCoeff(),
            1e-3);  // Euler's drift
  EXPECT_LT((seen.angularVelocity - sample.attitude.conjugate() * sample.angularVelocity).norm(),
            1e-12);
}

TEST(ReferenceFrame, OfTheMomentumHasItUpright) {
  const physics::Sample sample = tumblingSample(),
                        seen = MotionFrame(ReferenceFrame::Momentum).seen(sample);
  const double size = sample.angularMomentum.norm();
  EXPECT_GT((sample.angularMomentum - size * Eigen::Vector3d::UnitY()).norm(), size / 2);
  EXPECT_LT((seen.angularMomentum - size * Eigen::Vector3d::UnitY()).norm(), kFrameBound * size);
}

TEST(ReferenceFrame, TurnsAllVectorsAlike) {
  const physics::Sample sample = tumblingSample();
  for (const auto frame : {ReferenceFrame::Body, ReferenceFrame::Momentum}) {
    const Eigen::Matrix3d turn = MotionFrame(frame).fromWorld(sample);
    EXPECT_LT((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), kFrameBound);
    EXPECT_NEAR(turn.determinant(), 1, kFrameBound);
    const physics::Sample seen = MotionFrame(frame).seen(sample);
    EXPECT_NEAR(seen.angularVelocity.dot(seen.angularMomentum),
                sample.angularVelocity.dot(sample.angularMomentum), kFrameBound);
    EXPECT_LT((seen.attitude * body::Cuboid().corners().col(7) -
               turn * (sample.attitude * body::Cuboid().corners().col(7)))
                  .norm(),
              kFrameBound);
    EXPECT_EQ(seen.kinetic, sample.kinetic);
  }
}

TEST(ReferenceFrame, OfNoMomentumOrOneThatPointsDownIsARotation) {
  physics::Sample sample;
  EXPECT_EQ(MotionFrame(ReferenceFrame::Momentum).fromWorld(sample), Eigen::Matrix3d::Identity());
  for (const double slant : {0.0, 1e-9, 1e-5}) {
    sample.angularMomentum = {slant, -2, 0};
    const Eigen::Matrix3d turn = MotionFrame(ReferenceFrame::Momentum).fromWorld(sample);
    EXPECT_NEAR(turn.determinant(), 1, 1e-5) << slant;
    EXPECT_LT((turn * sample.angularMomentum - Eigen::Vector3d(0, 2, 0)).norm(), 1e-5) << slant;
  }
}

TEST(ReferenceFrame, TurnsEvenlyAsTheSpinWithoutItsTilt) {
  physics::MotionSettings settings;
  settings.initial.value = {0, 0, 5};
  settings.initial.tilt = {0.01, 0};
  const MotionFrame frame(ReferenceFrame::Turning, settings);
  EXPECT_EQ(frame.turningAt({}).rate, Eigen::Vector3d(0, 0, 5));
  physics::Sample sample;
  sample.angularVelocity = {1, 0, 0};
  EXPECT_EQ(frame.fromWorld(sample), Eigen::Matrix3d::Identity());
  for (const double time : {0.1, 1.0, 25.0, 3e5}) {
    sample.time = time;
    // What turns as the frame does is at rest in it
    const Eigen::Vector3d turned(std::cos(5 * time), std::sin(5 * time), 0);
    const double bound = 1e-15 * std::max(1.0, time);  // measured 1.3e-16, and 1.4e-10 at 3e5 s
    EXPECT_LT((frame.fromWorld(sample) * turned - Eigen::Vector3d::UnitX()).norm(), bound) << time;
  }
}

TEST(ReferenceFrame, ThatTurnsDoesSoAboutTheSpinOfABodyThatLies) {
  physics::MotionSettings settings;
  settings.initial.value = {0, 5, 0};
  settings.initial.attitude = Eigen::Vector4d(1, 1, 0, 0);  // a quarter turn about x
  const MotionFrame frame(ReferenceFrame::Turning, settings);
  EXPECT_LT((frame.turningAt({}).rate - Eigen::Vector3d(0, 0, 5)).norm(), 1e-14);  // measured 0
}

TEST(ReferenceFrame, ThatTurnsFollowsFromAMomentum) {
  physics::MotionSettings settings;
  settings.initial.kind = physics::InitialSpin::Kind::AngularMomentum;
  settings.initial.value = {0, 0.02, 0};
  const double moment = settings.body.solidInertia().y();
  EXPECT_NEAR(MotionFrame(ReferenceFrame::Turning, settings).turningAt({}).rate.y(), 0.02 / moment,
              1e-13);
  EXPECT_EQ(MotionFrame(ReferenceFrame::World, settings).turningAt({}).rate,
            Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace rotatebook::scene
