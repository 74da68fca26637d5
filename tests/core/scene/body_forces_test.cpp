#include "scene/body_forces.h"

#include <gtest/gtest.h>

#include "physics/simulate.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

Scene sceneWith(const std::string& body) {
  return parseScene(body + "\n[initial]\nangular_velocity = [0, 5, 0.1]\n", "a.toml");
}

/// Returns the sum of m (r^2 - r r^T) over masses that share `mass`. [kg m^2]
Eigen::Matrix3d inertiaOf(const BodyForces& forces, double mass) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& r : forces.places())
    sum += r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose();
  return sum * mass / static_cast<double>(forces.places().size());
}

TEST(BodyForces, ActOnEightMassesWithTheBodysMoments) {
  const Scene scene = sceneWith("");
  const Motion& motion = scene.motions[0];
  const BodyForces forces(motion, MotionFrame(ReferenceFrame::World));
  ASSERT_EQ(forces.places().size(), 8U);
  const Eigen::Matrix3d expected = motion.body.solidInertia().asDiagonal();
  EXPECT_LT((inertiaOf(forces, motion.body.mass) - expected).norm(), 1e-17);  // measured 2e-18
}

TEST(BodyForces, ActOnThePapersParticlesWhereThereAreSome) {
  const Scene scene = sceneWith("[simulation]\nmodel = 'particles'");
  const BodyForces forces(scene.motions[0], MotionFrame(ReferenceFrame::World));
  const physics::Cage corners = scene.motions[0].body.corners();
  for (int i = 0; i < 8; ++i) {
    EXPECT_LT((forces.places()[static_cast<std::size_t>(i)] - corners.col(i)).norm(),
              1e-16);  // measured 1.1e-17
  }
}

TEST(BodyForces, ActOnTheWeightsOfADisc) {
  const Scene scene = sceneWith("[body]\nshape = 'weighted-disc'");
  const BodyForces forces(scene.motions[0], MotionFrame(ReferenceFrame::World));
  ASSERT_EQ(forces.places().size(), 4U);
  EXPECT_EQ(forces.places()[0], Eigen::Vector3d(0.15, 0, 0));
  EXPECT_EQ(forces.places()[3], Eigen::Vector3d(0, -0.15, 0));
}

TEST(BodyForces, AreOfTheKindsThatTheFrameHas) {
  const Scene scene = sceneWith("");
  const Motion& motion = scene.motions[0];
  const physics::Sample sample = physics::simulate(motion, 60).samples.back();
  const auto forcesIn = [&](ReferenceFrame kind) {
    const MotionFrame frame(kind, motion);
    return BodyForces(motion, frame).at(frame.seen(sample)).front();
  };
  const rigid::ForcesPerMass world = forcesIn(ReferenceFrame::World),
                             body = forcesIn(ReferenceFrame::Body),
                             turning = forcesIn(ReferenceFrame::Turning);
  EXPECT_EQ(world.centrifugal + world.coriolis + world.euler, Eigen::Vector3d::Zero());
  EXPECT_LT(body.coriolis.norm(), 1e-14);  // measured 1.8e-19
  EXPECT_GT(body.euler.norm(), 0.01);
  EXPECT_LT(body.sum().norm(), 1e-14);  // measured 0
  EXPECT_EQ(turning.euler, Eigen::Vector3d::Zero());
  EXPECT_GT(turning.coriolis.norm(), 0.1);
  // Whoever looks, the body does the same
  EXPECT_NEAR(body.held.norm(), world.held.norm(), 1e-14);     // measured 7e-16
  EXPECT_NEAR(turning.held.norm(), world.held.norm(), 1e-14);  // measured 4.5e-16
}

}  // namespace
}  // namespace rotatebook::scene
