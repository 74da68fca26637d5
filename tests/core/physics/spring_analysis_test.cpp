#include "physics/spring_analysis.h"

#include <cmath>
#include <iostream>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "physics/integrator_names.h"
#include "physics/lattice_of_springs.h"
#include "physics/particle_places.h"

namespace rotatebook::physics {
namespace {

using Eigen::Vector3d;

constexpr double kEigenvalueBound = 1e-8;  // relative; measured 1.4e-10

MassSpringSystem cube() {
  return particlesOf(spinning(Model::Particles, {0, 0, 1}, 1));
}

/// Returns the points with all springs between them.
MassSpringSystem allJoined(std::vector<Vector3d> places) {
  const std::size_t count = places.size();
  return {std::move(places), allPairs(count)};
}

/// Returns the same places with only the springs along the sides of the box.
MassSpringSystem frame() {
  MassSpringSystem system = cube();
  std::erase_if(system.springs, [](const Spring& spring) {
    const std::uint32_t differing = spring.a ^ spring.b;
    return differing != 1 && differing != 2 && differing != 4;
  });
  return system;
}

/// Returns the eigenvalues of the whole matrix, the smallest first.
Eigen::VectorXd eigenvaluesOf(const MassSpringSystem& system) {
  const auto size = static_cast<Eigen::Index>(3 * system.places.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (const Spring& spring : system.springs) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
    const Vector3d along = (system.places[spring.b] - system.places[spring.a]).normalized();
    row.segment<3>(3 * spring.b) = along;
    row.segment<3>(3 * spring.a) = -along;
    matrix += row * row.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
}

/// Returns the number of independent motions that leave the springs' lengths as they are.
int countZeroModes(const MassSpringSystem& system) {
  constexpr double kZero = 1e-9;  // measured 4e-15
  return static_cast<int>((eigenvaluesOf(system).array() < kZero).count());
}

TEST(SpringAnalysis, ABodyHasSixZeroModes) {
  EXPECT_EQ(countZeroModes(cube()), 6);
  EXPECT_TRUE(holdShape(cube()));
  EXPECT_EQ(countZeroModes(block()), 6);
  EXPECT_TRUE(holdShape(block()));
  const MassSpringSystem simplex = allJoined({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(countZeroModes(simplex), 6);
  EXPECT_TRUE(holdShape(simplex));
}

TEST(SpringAnalysis, CountsTheModesOfWhatIsFloppy) {
  // 24 coordinates and twelve springs, none of which the others replace.
  EXPECT_EQ(countZeroModes(frame()), 12);
  EXPECT_FALSE(holdShape(frame()));
  // A plane: five coordinates of eight are held in it, none across.
  const MassSpringSystem plane = allJoined({{1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}});
  EXPECT_EQ(countZeroModes(plane), 7);
  EXPECT_FALSE(holdShape(plane));
  const MassSpringSystem line = allJoined({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(countZeroModes(line), 7);
  EXPECT_FALSE(holdShape(line));
}

TEST(SpringAnalysis, OneSpringTooFewIsNoticed) {
  MassSpringSystem simplex = allJoined({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  simplex.springs.pop_back();
  EXPECT_EQ(countZeroModes(simplex), 7);
  EXPECT_FALSE(holdShape(simplex));
}

TEST(SpringAnalysis, CountsPieces) {
  MassSpringSystem two = block();
  EXPECT_EQ(countPieces(two), 1);
  const auto count = static_cast<std::uint32_t>(two.places.size());
  for (std::uint32_t i = 0; i < count; ++i) two.places.push_back(two.places[i] + Vector3d(9, 0, 0));
  const std::size_t springs = two.springs.size();
  for (std::size_t i = 0; i < springs; ++i)
    two.springs.push_back({two.springs[i].a + count, two.springs[i].b + count});
  EXPECT_EQ(countPieces(two), 2);
  EXPECT_EQ(countZeroModes(two), 12);
  EXPECT_FALSE(holdShape(two));
}

// The paper's network: 8 k/m, whatever the box.
TEST(LargestEigenvalue, IsEightForAllPairsOfABoxsCorners) {
  EXPECT_NEAR(largestEigenvalue(cube()), 8, 8 * kEigenvalueBound);
  MotionSettings flat = spinning(Model::Particles, {0, 0, 1}, 1);
  flat.body.size = {1, 2, 0.01};
  EXPECT_NEAR(largestEigenvalue(particlesOf(flat)), 8, 8 * kEigenvalueBound);
}

TEST(LargestEigenvalue, IsThatOfTheWholeMatrix) {
  for (const MassSpringSystem& system : {block(), frame()}) {
    const double expected = eigenvaluesOf(system).maxCoeff();
    std::cout << expected << ' ' << largestEigenvalue(system) / expected - 1 << '\n';
    EXPECT_NEAR(largestEigenvalue(system) / expected, 1, kEigenvalueBound);
  }
}

double limitOf(const MotionSettings& settings) {
  return largestStableStep(settings, particlesOf(settings));
}

// The limits that particle_integrators_test.cpp tries out.
TEST(LargestStableStep, IsTheDocumentedOneForTheBook) {
  const auto limit = [](Integrator integrator, double damping) {
    MotionSettings settings = spinning(Model::Particles, {0, 0, 1}, 1);
    settings.simulation.integrator = integrator;
    settings.simulation.damping = damping;
    return limitOf(settings) * std::sqrt(settings.simulation.stiffness / (settings.body.mass / 8));
  };
  EXPECT_NEAR(limit(Integrator::Euler, 1), 0.12917, 1e-5);
  EXPECT_NEAR(limit(Integrator::SymplecticEuler, 1), 0.12132, 1e-5);
  EXPECT_NEAR(limit(Integrator::Verlet, 1), 0.125, 1e-5);
  EXPECT_NEAR(limit(Integrator::Rk4, 1), 0.17990, 1e-5);
  EXPECT_NEAR(limit(Integrator::SymplecticEuler, 0), 0.70711, 1e-5);
  EXPECT_NEAR(limit(Integrator::Verlet, 0), 0.70711, 1e-5);
  EXPECT_NEAR(limit(Integrator::Rk4, 0), 1, 1e-4);
  EXPECT_EQ(limit(Integrator::Euler, 0), 0);
}

/// Returns whether the springs hold less energy, after so many steps, than the spin had at first.
bool holdsTogether(MotionSettings settings, double factor) {
  constexpr int kManySteps = 10000;
  const double h = factor * limitOf(settings);
  const auto simulator = makeSimulator(settings);
  const double spin = simulator->state().rotational;
  simulator->advance(kManySteps * h, kManySteps);
  return simulator->state().potential < spin;
}

TEST(LargestStableStep, IsWhereManyParticlesBlowUp) {
  for (const Integrator integrator :
       {Integrator::Euler, Integrator::SymplecticEuler, Integrator::Verlet, Integrator::Rk4}) {
    for (const double damping : {0.0, 0.1, 1.0}) {
      if (integrator == Integrator::Euler && damping == 0) continue;  // stable with no step
      MotionSettings settings = blockMotion({0.01, 0.02, 0.03}, 1);
      settings.simulation.integrator = integrator;
      settings.simulation.damping = damping;
      settings.simulation.normalizeEvery = 0;
      EXPECT_TRUE(holdsTogether(settings, 0.99)) << nameOf(integrator) << damping;
      EXPECT_FALSE(holdsTogether(settings, 1.01)) << nameOf(integrator) << damping;
    }
  }
}

}  // namespace
}  // namespace rotatebook::physics
