// Steps that lanes leave to Newton's method, and matrices that they leave to an SVD.
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include <Eigen/Core>

#include "physics/steps/branch.h"
#include "rigid/rotation.h"
#include "study/lanes/block.h"

namespace rotatebook::study::lanes {
namespace {

template <typename Equation>
bool solveEquation(const double* numbers, double* solution) {
  Equation equation;
  std::memcpy(&equation, numbers, sizeof(equation));
  const std::optional<physics::Vector3<double>> found = followedBranch(equation);
  if (found) std::memcpy(solution, &*found, sizeof(*found));
  return found.has_value();
}

}  // namespace

bool solveMidpoint(const double* equation, double* solution) {
  return solveEquation<physics::MidpointEquation<double>>(equation, solution);
}

bool solveMoserVeselov(const double* equation, double* solution) {
  return solveEquation<physics::MoserVeselovEquation<double>>(equation, solution);
}

void takePolarFactor(double* matrix) {
  Eigen::Map<Eigen::Matrix3d> map(matrix);
  map = rigid::polarFactor(map);
}

}  // namespace rotatebook::study::lanes
