// The solver of implicit integrators' steps.
#pragma once

#include <limits>

#include <Eigen/Core>

namespace rotatebook::physics {

/// Throws NoConvergence: `integrator` finds no solution for a step of `h` [s].
[[noreturn]] void throwNoConvergence(const char* integrator, double h);

/// Returns the fixed point of `next`, iterated from `start` until it changes by rounding alone.
/// Throws NoConvergence after 100 iterations, or if the numbers are not finite.
template <typename Next>
Eigen::Vector3d fixedPoint(const Eigen::Vector3d& start, const Next& next, const char* integrator,
                           double h) {
  constexpr int kMaxIterations = 100;
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  Eigen::Vector3d x = start;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const Eigen::Vector3d better = next(x);
    const double change = (better - x).cwiseAbs().maxCoeff();
    x = better;
    // Infinite numbers pass the first condition, because inf <= inf.
    if (change <= kRounding * x.cwiseAbs().maxCoeff() && x.allFinite()) return x;
  }
  throwNoConvergence(integrator, h);
}

}  // namespace rotatebook::physics
