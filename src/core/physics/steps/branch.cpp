#include "physics/steps/branch.h"

#include <algorithm>
#include <limits>

#include <Eigen/Core>
#include <Eigen/LU>

#include "physics/integrators/eigen_numbers.h"
#include "rigid/rotation.h"

namespace rotatebook::physics {
namespace {

// Each equation, as Newton's method needs it: the solution at share 0, which moves with share, and
// the derivative of next().
Eigen::Vector3d solutionAtZero(const MidpointEquation<double>& equation) {
  return toEigen(equation.momentum);
}

Eigen::Matrix3d derivative(const MidpointEquation<double>& equation, const Eigen::Vector3d& middle,
                           double share) {
  const Eigen::Vector3d inverseInertia = toEigen(equation.inverseInertia);
  const Eigen::Vector3d velocity = inverseInertia.cwiseProduct(middle);
  return share * equation.h / 2 *
         (rigid::crossMatrix(middle) * inverseInertia.asDiagonal() - rigid::crossMatrix(velocity));
}

Eigen::Vector3d solutionAtZero(const MoserVeselovEquation<double>& /*equation*/) {
  return {0, 0, 0};
}

Eigen::Matrix3d derivative(const MoserVeselovEquation<double>& equation, const Eigen::Vector3d& c,
                           double share) {
  Eigen::Matrix3d ofProducts;
  ofProducts << 0, c.z(), c.y(), c.z(), 0, c.x(), c.y(), c.x(), 0;
  return 2 * share * toEigen(equation.a) * c.transpose() +
         toEigen(equation.ratios).asDiagonal() * ofProducts;
}

bool isWithinRounding(const Eigen::Vector3d& change, const Eigen::Vector3d& x) {
  // An infinite change is no larger than the rounding of an infinite number.
  return change.cwiseAbs().maxCoeff() <= kSolverRounding * x.cwiseAbs().maxCoeff() && x.allFinite();
}

// Solves by Newton's method from `x`. Returns nothing if that doesn't converge, or leads past a
// fold of the branch of solutions: the determinant of 1 - df/dx is 1 at share 0 and 0 at a fold.
template <typename Equation>
std::optional<Eigen::Vector3d> newton(Eigen::Vector3d x, const Equation& equation, double share) {
  double last = std::numeric_limits<double>::infinity();
  for (;;) {
    const Eigen::Matrix3d slope = Eigen::Matrix3d::Identity() - derivative(equation, x, share);
    if (!(slope.determinant() > 0)) return std::nullopt;
    const Eigen::Vector3d next = toEigen(equation.next(toNumbers(x), share));
    const Eigen::Vector3d correction = slope.inverse() * (next - x);
    x += correction;
    if (isWithinRounding(correction, x)) return x;
    const double size = correction.cwiseAbs().maxCoeff();
    if (!(size < last / 2)) return std::nullopt;
    last = size;
  }
}

// Goes in as long strides as it converges for. Nothing if strides of 1/4096 are too long: there the
// branch ends.
template <typename Equation>
std::optional<Vector3<double>> followed(const Equation& equation) {
  constexpr double kShortestStride = 1.0 / 4096;
  Eigen::Vector3d x = solutionAtZero(equation);
  double share = 0;
  for (double stride = 0.5; share < 1;) {
    const double target = std::min(1.0, share + stride);
    if (const auto found = newton(x, equation, target)) {
      x = *found;
      share = target;
      continue;
    }
    stride /= 2;
    if (stride < kShortestStride) return std::nullopt;
  }
  return toNumbers(x);
}

}  // namespace

std::optional<Vector3<double>> followedBranch(const MidpointEquation<double>& equation) {
  return followed(equation);
}

std::optional<Vector3<double>> followedBranch(const MoserVeselovEquation<double>& equation) {
  return followed(equation);
}

}  // namespace rotatebook::physics
