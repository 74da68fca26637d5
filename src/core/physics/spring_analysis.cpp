#include "physics/spring_analysis.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include "base/disjoint_sets.h"
#include "physics/integrators/integrator_table.h"

namespace rotatebook::physics {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Returns the unit vector along a spring; 0 if its ends are at one place.
Vector3d directionOf(const MassSpringSystem& system, const Spring& spring) {
  const Vector3d arm = system.places[spring.b] - system.places[spring.a];
  const double length = std::sqrt(arm.squaredNorm());
  return length > 0 ? Vector3d(arm / length) : Vector3d::Zero();
}

/// Returns the row of the stiffness matrix where a particle's three begin.
Index firstRow(std::uint32_t particle) {
  return 3 * static_cast<Index>(particle);
}

/// Passes the blocks of the stiffness matrix of springs of stiffness 1, which add up:
/// add(particle, particle, block).
template <typename Add>
void forEachBlock(const MassSpringSystem& system, const Add& add) {
  for (const Spring& spring : system.springs) {
    const Vector3d along = directionOf(system, spring);
    const Matrix3d block = along * along.transpose();
    add(spring.a, spring.a, block);
    add(spring.b, spring.b, block);
    add(spring.a, spring.b, -block);
    add(spring.b, spring.a, -block);
  }
}

template <typename Distance>
std::uint32_t farthest(const MassSpringSystem& system, const Distance& distance) {
  const auto best = std::ranges::max_element(system.places, {}, distance);
  return static_cast<std::uint32_t>(best - system.places.begin());
}

/// Passes the blocks of three particles' holds, which stop the six rigid motions: one particle is
/// held, another across the line between them, a third across their plane.
template <typename Add>
void forEachHold(const MassSpringSystem& system, const Add& add) {
  const auto& places = system.places;
  const auto a = farthest(system, [](const Vector3d& p) { return p.squaredNorm(); });
  const auto b = farthest(system, [&](const Vector3d& p) { return (p - places[a]).squaredNorm(); });
  const Vector3d line = (places[b] - places[a]).normalized();
  const auto c =
      farthest(system, [&](const Vector3d& p) { return line.cross(p - places[a]).squaredNorm(); });
  const Vector3d normal = line.cross(places[c] - places[a]).normalized();
  add(a, a, Matrix3d::Identity());
  add(b, b, Matrix3d::Identity() - line * line.transpose());
  add(c, c, normal * normal.transpose());
}

/// y += K x
void addProduct(const MassSpringSystem& system, const std::vector<Vector3d>& directions,
                const VectorXd& x, VectorXd& y) {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Index a = firstRow(system.springs[i].a), b = firstRow(system.springs[i].b);
    const double stretch = directions[i].dot(x.segment<3>(b) - x.segment<3>(a));
    y.segment<3>(b) += stretch * directions[i];
    y.segment<3>(a) -= stretch * directions[i];
  }
}

/// Returns numbers between -1 and 1 that look like chance, always the same.
VectorXd scattered(Index count) {
  VectorXd numbers(count);
  std::uint64_t state = 1;
  for (double& number : numbers) {
    state = state * 6364136223846793005U + 1442695040888963407U;  // Knuth's MMIX
    number = static_cast<double>(state >> 11) * 0x1p-52 - 1;
  }
  return numbers;
}

double largestOfTridiagonal(const std::vector<double>& diagonal,
                            const std::vector<double>& beside) {
  const auto size = static_cast<Index>(diagonal.size());
  const VectorXd d = Eigen::Map<const VectorXd>(diagonal.data(), size);
  const VectorXd e = Eigen::Map<const VectorXd>(beside.data(), size - 1);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(d, e, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[size - 1];
}

}  // namespace

bool holdShape(const MassSpringSystem& system) {
  // Of a spring's stiffness. Measured: 0.01 and more of springs that hold, 4e-14 and less of
  // others.
  constexpr double kSmallestPivot = 1e-9;
  if (system.places.size() < 3) return false;
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](std::uint32_t row, std::uint32_t column, const Matrix3d& block) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        entries.emplace_back(static_cast<int>(3 * row) + i, static_cast<int>(3 * column) + j,
                             block(i, j));
    }
  };
  forEachBlock(system, add);
  forEachHold(system, add);
  const auto size = static_cast<Index>(3 * system.places.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  return factors.info() == Eigen::Success && factors.vectorD().minCoeff() > kSmallestPivot;
}

int countPieces(const MassSpringSystem& system) {
  DisjointSets sets(system.places.size());
  for (const Spring& spring : system.springs) sets.join(spring.a, spring.b);
  int pieces = 0;
  for (std::uint32_t i = 0; i < system.places.size(); ++i) {
    if (sets.of(i) == i) ++pieces;
  }
  return pieces;
}

double largestEigenvalue(const MassSpringSystem& system) {
  constexpr double kPrecise = 1e-9;
  constexpr int kMaxIterations = 300;
  std::vector<Vector3d> directions;
  for (const Spring& spring : system.springs) directions.push_back(directionOf(system, spring));
  VectorXd before = VectorXd::Zero(static_cast<Index>(3 * system.places.size()));
  VectorXd now = scattered(before.size()).normalized();
  std::vector<double> diagonal, beside;
  double largest = 0;
  for (int i = 0; i < kMaxIterations; ++i) {
    VectorXd next = beside.empty() ? VectorXd::Zero(now.size()) : VectorXd(-beside.back() * before);
    addProduct(system, directions, now, next);
    diagonal.push_back(now.dot(next));
    next -= diagonal.back() * now;
    const double last = largest;
    largest = largestOfTridiagonal(diagonal, beside);
    const double norm = next.norm();
    // Stop when it grows no more, but not because it hasn't begun to
    const bool hasSettled = i >= 20 && largest - last <= kPrecise * largest;
    if (hasSettled || norm <= kPrecise * largest) break;
    beside.push_back(norm);
    before = now;
    now = next / norm;
  }
  return largest;
}

double largestStableStep(const MotionSettings& settings, const MassSpringSystem& system) {
  const physics::SimulationSettings& simulation = settings.simulation;
  const double mass = settings.body.mass / static_cast<double>(system.places.size());
  const double eigenvalue = largestEigenvalue(system), k = simulation.stiffness;
  const double damping = simulation.damping * 2 * std::sqrt(k * mass);
  // Dampers act along the springs, so that a mode's damping is in proportion to its stiffness. The
  // stiffest mode is the first to become unstable
  const Stepping* stepping = steppingOf(simulation.model, simulation.integrator);
  return stepping->stableStep(eigenvalue * k / mass, eigenvalue * damping / mass);
}

}  // namespace rotatebook::physics
