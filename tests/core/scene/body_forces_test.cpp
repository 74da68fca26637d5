#include "scene/body_forces.h"

#include <algorithm>

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
  const body::Cage corners = scene.motions[0].body.corners();
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

TEST(BodyForces, FollowAMotionThatLosesEnergy) {
  const Scene scene = sceneWith(
      "[simulation]\nintegrator = 'cf4'\ndissipation = 2e-4\ntime_per_frame = 0.001\n"
      "substeps = 8");
  const Motion& motion = scene.motions[0];
  const auto samples = physics::simulate(motion, 3000).samples;
  const BodyForces inWorld(motion, MotionFrame(ReferenceFrame::World)),
      inBody(motion, MotionFrame(ReferenceFrame::Body));
  const Eigen::Vector3d place = inWorld.places()[0], inertia = motion.body.solidInertia();
  const auto at = [&](std::size_t n) { return Eigen::Vector3d(samples[n].attitude * place); };
  const auto rateAt = [&](std::size_t n) {
    const Eigen::Vector3d w = samples[n].attitude.conjugate() * samples[n].angularVelocity;
    const Eigen::Vector3d a = inertia.cwiseProduct(w).cross(w).cwiseQuotient(inertia);
    return Eigen::Vector3d(w + 2e-4 * a.cwiseQuotient(inertia));
  };
  const MotionFrame body(ReferenceFrame::Body);
  Motion free = motion;
  free.simulation.dissipation = 0;
  const BodyForces withoutSink(free, MotionFrame(ReferenceFrame::World));
  double held = 0, euler = 0, lossless = 0;  // errors [N/kg]
  for (std::size_t n = 1; n + 1 < samples.size(); ++n) {
    const Eigen::Vector3d acceleration = (at(n + 1) - 2 * at(n) + at(n - 1)) / 1e-6;
    held = std::max(held, (inWorld.at(samples[n])[0].held - acceleration).norm());
    lossless = std::max(lossless, (withoutSink.at(samples[n])[0].held - acceleration).norm());
    const Eigen::Vector3d ofRate = (rateAt(n + 1) - rateAt(n - 1)) / 2e-3;
    euler =
        std::max(euler, (inBody.at(body.seen(samples[n]))[0].euler + ofRate.cross(place)).norm());
  }
  EXPECT_LT(held, 1e-5);       // measured 3.04e-6
  EXPECT_LT(euler, 1e-6);      // measured 1.03e-7
  EXPECT_GT(lossless, 0.005);  // measured 0.0096
}

TEST(BodyForces, AreNoneLargerThanTheLargest) {
  const Scene scene = sceneWith("");
  const Motion& motion = scene.motions[0];
  const physics::Sample sample = physics::simulate(motion, 60).samples.back();
  for (const ReferenceFrame kind : {ReferenceFrame::World, ReferenceFrame::Body,
                                    ReferenceFrame::Turning, ReferenceFrame::Momentum}) {
    const MotionFrame frame(kind, motion);
    const BodyForces forces(motion, frame);
    double largest = 0;
    for (const rigid::ForcesPerMass& mass : forces.at(frame.seen(sample))) {
      for (const Eigen::Vector3d& force : {mass.held, mass.centrifugal, mass.coriolis, mass.euler})
        largest = std::max(largest, force.norm());
    }
    EXPECT_DOUBLE_EQ(forces.largestAt(sample), largest);
    EXPECT_GT(largest, 0.1);
  }
}

}  // namespace
}  // namespace rotatebook::scene
