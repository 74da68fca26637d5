// The solver of implicit integrators' steps. Inside the room only.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Core>
#include <Eigen/LU>

namespace rotatebook::physics {

/// Throws NoConvergence: `integrator` finds no solution for a step of `h` [s].
[[noreturn]] void throwNoConvergence(const char* integrator, double h);

/// An equation x = f(x, share) of an implicit step: share 1 is the step itself, share 0 one of no
/// length, whose solution is known; between them the solution moves with share.
template <typename Equation>
concept StepEquation = requires(const Equation& equation, const Eigen::Vector3d& x, double share) {
  { equation.solutionAtZero() } -> std::convertible_to<Eigen::Vector3d>;
  { equation.next(x, share) } -> std::convertible_to<Eigen::Vector3d>;        // f
  { equation.derivative(x, share) } -> std::convertible_to<Eigen::Matrix3d>;  // df/dx
};

inline constexpr double kSolverRounding = 4 * std::numeric_limits<double>::epsilon();

inline bool isWithinRounding(const Eigen::Vector3d& change, const Eigen::Vector3d& x) {
  // An infinite change is no larger than the rounding of an infinite number.
  return change.cwiseAbs().maxCoeff() <= kSolverRounding * x.cwiseAbs().maxCoeff() && x.allFinite();
}

/// Returns the fixed point of the whole step, iterated until the change is rounding and falls no
/// more, so that the error left has no preferred direction. Nothing after 100 iterations.
template <StepEquation Equation>
std::optional<Eigen::Vector3d> fixedPoint(const Eigen::Vector3d& start, const Equation& equation) {
  constexpr int kMaxIterations = 100;
  Eigen::Vector3d x = start;
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const Eigen::Vector3d better = equation.next(x, 1);
    const Eigen::Vector3d difference = better - x;
    const double change = difference.cwiseAbs().maxCoeff();
    x = better;
    if (isWithinRounding(difference, x) && !(change < last && change > 0)) return x;
    last = change;
  }
  return std::nullopt;
}

/// Solves by Newton's method from `x`. Returns nothing if that doesn't converge, or leads past a
/// fold of the branch of solutions: the determinant of 1 - df/dx is 1 at share 0 and 0 at a fold.
template <StepEquation Equation>
std::optional<Eigen::Vector3d> newton(Eigen::Vector3d x, const Equation& equation, double share) {
  double last = std::numeric_limits<double>::infinity();
  for (;;) {
    const Eigen::Matrix3d slope = Eigen::Matrix3d::Identity() - equation.derivative(x, share);
    if (!(slope.determinant() > 0)) return std::nullopt;
    const Eigen::Vector3d correction = slope.inverse() * (equation.next(x, share) - x);
    x += correction;
    if (isWithinRounding(correction, x)) return x;
    const double size = correction.cwiseAbs().maxCoeff();
    if (!(size < last / 2)) return std::nullopt;
    last = size;
  }
}

/// Follows the solution from share 0 to the whole step by Newton's method, in as long strides as it
/// converges for. Nothing if strides of 1/4096 are too long: there the branch ends.
template <StepEquation Equation>
std::optional<Eigen::Vector3d> followedSolution(const Equation& equation) {
  constexpr double kShortestStride = 1.0 / 4096;
  Eigen::Vector3d x = equation.solutionAtZero();
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
  return x;
}

/// Solves a step's equation to rounding: by fixed-point iteration, and by Newton's method where
/// that doesn't converge. Throws NoConvergence where the solution that belongs to short steps has
/// ended.
template <StepEquation Equation>
Eigen::Vector3d solveStep(const Eigen::Vector3d& start, const Equation& equation,
                          const char* integrator, double h) {
  if (const auto found = fixedPoint(start, equation)) return *found;
  if (const auto found = followedSolution(equation)) return *found;
  throwNoConvergence(integrator, h);
}

/// Adds `increment` to `sum` with what rounding has left over before (Kahan's summation).
inline void addCompensated(const Eigen::Vector3d& increment, Eigen::Vector3d& sum,
                           Eigen::Vector3d& carry) {
  const Eigen::Vector3d whole = increment + carry;
  const Eigen::Vector3d next = sum + whole;
  carry = whole - (next - sum);
  sum = next;
}

}  // namespace rotatebook::physics
