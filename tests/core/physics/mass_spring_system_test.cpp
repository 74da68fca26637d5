// Particles that aren't the corners of a box.
#include "physics/mass_spring_system.h"

#include <cmath>
#include <iostream>
#include <memory>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/error.h"
#include "physics/lattice_of_springs.h"
#include "physics/particle_fit.h"
#include "physics/particle_places.h"
#include "rigid/inertia.h"

namespace rotatebook::physics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kTensorBound = 1e-15;       // relative; measured 3e-16
constexpr double kSameSpringMotion = 1e-12;  // measured 6e-17
constexpr double kMomentumBound = 1e-13;     // measured 2e-15
constexpr double kEnergyBound = 1e-14;       // measured 9e-16
constexpr double kBoxBound = 1e-14;          // measured 4e-15

Matrix3d turn() {
  return Eigen::AngleAxisd(0.8, Vector3d(1, -2, 2) / 3).toRotationMatrix();
}

TEST(EquimomentalParticles, HaveTheBodysTensor) {
  for (const Vector3d& moments :
       {Vector3d(1, 2, 2.5), Vector3d(3, 3, 3), Vector3d(1, 1, 1.999), Vector3d(5, 1, 4.5)}) {
    for (const Matrix3d& axes : {Matrix3d(Matrix3d::Identity()), turn()}) {
      const Matrix3d tensor = axes * moments.asDiagonal() * axes.transpose();
      const MassSpringSystem system{
          equimomentalPlaces(rigid::principalAxes((tensor + tensor.transpose()) / 2), 0.7), {}};
      const double error = (system.inertia(0.7) - tensor).norm() / tensor.norm();
      std::cout << error << '\n';
      EXPECT_LT(error, kTensorBound);
    }
  }
}

// p^2 = (I_y + I_z - I_x) / (2 M): the arms of a solid box's particles are its half edges / sqrt 3.
TEST(EquimomentalParticles, OfABoxAreItsCornersBySqrt3) {
  MotionSettings settings = spinning(Model::Particles, {1, 2, 3}, 0.01);
  settings.simulation.particles = {Arrangement::Equimomental};
  const body::Cage corners = settings.body.corners();
  const MassSpringSystem system = particlesOf(settings);
  ASSERT_EQ(system.places.size(), 8U);
  EXPECT_EQ(system.springs.size(), 28U);
  for (int i = 0; i < 8; ++i) {
    const Vector3d expected = corners.col(i) / std::sqrt(3.0);
    EXPECT_LT((system.places[static_cast<std::size_t>(i)] - expected).norm(), 1e-16);
  }
  EXPECT_LT((modelInertia(settings).moments - settings.body.solidInertia()).norm(), 1e-17);
}

TEST(EquimomentalParticles, TakeAStatedInertia) {
  MotionSettings settings = spinning(Model::Particles, {1, 2, 3}, 0.01);
  settings.simulation.particles = {Arrangement::Equimomental};
  settings.inertia = Vector3d(0.002, 0.003, 0.004).asDiagonal();
  EXPECT_LT((modelInertia(settings).moments - Vector3d(0.002, 0.003, 0.004)).norm(), 1e-17);
}

// The cage is the book's, thirty times as far from the origin as rounding.
TEST(EquimomentalParticles, StartInTheBodysBox) {
  MotionSettings settings = spinning(Model::Particles, {1, 2, 3}, 0.01);
  settings.simulation.particles = {Arrangement::Equimomental};
  const BodyState state = makeSimulator(settings)->state();
  EXPECT_LT((*state.cage - settings.body.corners()).norm(), kBoxBound);
  EXPECT_LT((state.worldFromBody - Matrix3d::Identity()).norm(), kBoxBound);
}

TEST(ManySprings, MoveTheCornersAsTheNetworkOfEightDoes) {
  MotionSettings eight = spinning(Model::Particles, {3, -4, 5}, 1e-3);
  eight.simulation.stiffness = 300;
  MotionSettings many = eight;
  many.simulation.particles = {Arrangement::Vertices};
  many.particles.system = std::make_shared<const MassSpringSystem>(particlesOf(eight));
  for (const Integrator integrator : {Integrator::Euler, Integrator::Verlet, Integrator::Rk4}) {
    eight.simulation.integrator = many.simulation.integrator = integrator;
    const auto a = makeSimulator(eight), b = makeSimulator(many);
    a->advance(0.1, 100);
    b->advance(0.1, 100);
    const double apart = (*a->state().cage - *b->state().cage).norm();
    std::cout << apart << ' ' << a->state().kinetic << '\n';
    EXPECT_LT(apart, kSameSpringMotion);
    EXPECT_NEAR(b->state().potential / a->state().potential, 1, 1e-9);
  }
}

TEST(ManyParticles, NeedToBePlaced) {
  MotionSettings settings = spinning(Model::Particles, {1, 2, 3}, 0.01);
  settings.simulation.particles = {Arrangement::Grid, 4};
  EXPECT_THROW(makeSimulator(settings), InputError);
}

TEST(ManyParticles, KeepTheirAngularMomentum) {
  for (const Integrator integrator : {Integrator::SymplecticEuler, Integrator::Verlet}) {
    MotionSettings settings = blockMotion({3, 1, 2}, 1e-3);
    settings.simulation.integrator = integrator;
    settings.simulation.damping = 0;
    settings.simulation.normalizeEvery = 0;
    const auto simulator = makeSimulator(settings);
    const Vector3d start = simulator->state().angularMomentum;
    simulator->advance(5, 5000);
    const double drift = (simulator->state().angularMomentum - start).norm() / start.norm();
    std::cout << drift << '\n';
    EXPECT_LT(drift, kMomentumBound);
  }
}

TEST(ManyParticles, HaveTheEnergyOfTheirStartIfNormalised) {
  MotionSettings settings = blockMotion({3, 1, 2}, 1e-4);
  settings.simulation.damping = 0.1;
  const auto simulator = makeSimulator(settings);
  const double start = simulator->state().kinetic;
  double worst = 0, most = 0;
  for (int i = 0; i < 2000; ++i) {
    simulator->advance(1e-4, 1);
    const BodyState state = simulator->state();
    worst = std::max(worst, std::abs((state.kinetic + state.potential) / start - 1));
    most = std::max(most, state.potential / start);
  }
  std::cout << worst << ' ' << most << '\n';
  EXPECT_LT(worst, kEnergyBound);
  EXPECT_GT(most, 1e-5);
}

TEST(ManyParticles, AreNudged) {
  MotionSettings settings = blockMotion({3, 1, 2}, 1e-4);
  const auto simulator = makeSimulator(settings);
  simulator->nudge({.at = 0, .kind = SpinKind::AngularVelocity, .value = {0, 0, 4}});
  EXPECT_LT((simulator->state().angularVelocity - Vector3d(3, 1, 6)).norm(), 1e-13);
}

Eigen::Matrix3Xd matrixOf(const MassSpringSystem& system) {
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(system.places.size()));
  for (Eigen::Index i = 0; i < places.cols(); ++i)
    places.col(i) = system.places[static_cast<std::size_t>(i)];
  return places;
}

TEST(ParticleFit, MakesTheRigidBoxOfARigidMotion) {
  const body::Cuboid body{{0.2, 0.15, 0.1}};
  const ParticleFit fit(body, block());
  const Vector3d place(0.1, -0.2, 0.3);
  const Eigen::Matrix3Xd positions = (turn() * matrixOf(block())).colwise() + place;
  const body::Cage expected = (turn() * body.corners()).colwise() + place;
  const double apart = (fit.cageOf(positions) - expected).norm();
  std::cout << apart << ' ' << (fit.worldFromBody(positions) - turn()).norm() << '\n';
  EXPECT_LT(apart, kBoxBound);
  EXPECT_LT((fit.worldFromBody(positions) - turn()).norm(), kBoxBound);
}

TEST(ParticleFit, FollowsBends) {
  const body::Cuboid body{{0.2, 0.15, 0.1}};
  const ParticleFit fit(body, block());
  const auto bent = [](Eigen::Matrix3Xd points) {
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Vector3d p = points.col(i);
      points.col(i) += Vector3d(p.y() * p.z(), p.x() * p.z(), 5 * p.x() * p.y() * p.z());
    }
    return points;
  };
  const double apart = (fit.cageOf(bent(matrixOf(block()))) - bent(body.corners())).norm();
  std::cout << apart << '\n';
  EXPECT_LT(apart, kBoxBound);
}

// Four particles can't tell x y from the linear map: the box isn't bent at all.
TEST(ParticleFit, LeavesOutWhatParticlesDoNotTell) {
  const body::Cuboid body{{2, 2, 2}};
  const MassSpringSystem simplex{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, allPairs(4)};
  const Eigen::Matrix3Xd positions = turn() * matrixOf(simplex);
  EXPECT_LT((ParticleFit(body, simplex).cageOf(positions) - turn() * body.corners()).norm(), 1e-14);
}

}  // namespace
}  // namespace rotatebook::physics
