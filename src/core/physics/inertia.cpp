#include "physics/inertia.h"

#include <cmath>
#include <string>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "base/error.h"
#include "base/number_text.h"

namespace rotatebook::physics {
namespace {

// Of the largest entry: what rounding leaves in a tensor that a program has computed.
constexpr double kRounding = 1e-12;

// Products of several moments and spins are still normal numbers. [kg m^2]
constexpr double kLeastMoment = 1e-30;

void checkSymmetric(const Eigen::Matrix3d& tensor) {
  const double slack = kRounding * tensor.cwiseAbs().maxCoeff();
  for (int row = 0; row < 3; ++row) {
    for (int column = row + 1; column < 3; ++column) {
      const double here = tensor(row, column), there = tensor(column, row);
      if (std::abs(here - there) <= slack) continue;
      const std::string pair = {"xyz"[row], "xyz"[column]};
      throw InputError("an inertia tensor must be symmetric, but its " + pair + " entries are " +
                       shortestText(here) + " and " + shortestText(there));
    }
  }
}

// Rounded, because what an eigensolver finds is only near a whole number.
std::string momentsText(const Eigen::Vector3d& moments) {
  const auto text = [](double moment) { return roundedText(moment, 9); };
  return "its principal moments are " + text(moments[0]) + ", " + text(moments[1]) + " and " +
         text(moments[2]) + " kg m^2";
}

}  // namespace

Eigen::Vector3d PrincipalAxes::angularVelocity(const Eigen::Vector3d& momentum) const {
  return bodyFromPrincipal * (bodyFromPrincipal.transpose() * momentum).cwiseQuotient(moments);
}

Eigen::Vector3d PrincipalAxes::angularMomentum(const Eigen::Vector3d& velocity) const {
  return bodyFromPrincipal * moments.cwiseProduct(bodyFromPrincipal.transpose() * velocity);
}

void checkInertia(const Eigen::Matrix3d& tensor) {
  if (!tensor.allFinite()) throw InputError("an inertia tensor must be finite");
  checkSymmetric(tensor);
  const Eigen::Vector3d moments = principalAxes(tensor).moments;
  const double largest = moments.maxCoeff();
  if (!(moments.minCoeff() > 0)) {
    throw InputError("an inertia tensor must be positive definite, but " + momentsText(moments));
  }
  if (moments.minCoeff() <= kRounding * largest) {
    throw InputError(
        "an inertia tensor's smallest principal moment must be more than 1e-12 of the largest, "
        "but " +
        momentsText(moments));
  }
  if (largest < kLeastMoment) {
    throw InputError("an inertia tensor must have principal moments of 1e-30 kg m^2 or more, but " +
                     momentsText(moments));
  }
  if (largest > (1 + kRounding) * (moments.sum() - largest)) {
    throw InputError(
        "no body has this inertia: a principal moment can't exceed the sum of the other two, but " +
        momentsText(moments));
  }
}

PrincipalAxes principalAxes(const Eigen::Matrix3d& tensor) {
  if (tensor.isDiagonal(0)) return {tensor.diagonal(), Eigen::Matrix3d::Identity()};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver((tensor + tensor.transpose()) / 2);
  PrincipalAxes axes{solver.eigenvalues(), solver.eigenvectors()};
  if (axes.bodyFromPrincipal.determinant() < 0) {
    axes.bodyFromPrincipal.col(2) = -axes.bodyFromPrincipal.col(2);
  }
  return axes;
}

}  // namespace rotatebook::physics
