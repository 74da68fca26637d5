// Fixed points of implicit steps.
#pragma once

#include <limits>

#include "physics/steps/step_state.h"

namespace rotatebook::physics {

inline constexpr double kSolverRounding = 4 * std::numeric_limits<double>::epsilon();

/// The result of an iteration.
template <typename Number, typename Condition>
struct Iterated {
  Vector3<Number> x;
  Condition isSolved;
};

/// Iterates x <- `next`(x) for each body until its change is rounding and falls no more, so that
/// the error left has no preferred direction. Unsolved after 100 iterations, or from a start that
/// isn't finite.
template <typename Number, typename Next>
[[gnu::always_inline]] inline auto fixedPoint(const Vector3<Number>& start, const Next& next) {
  constexpr int kMaxIterations = 100;
  // Bodies that are solved are iterated with the others: what waits for no comparison is faster.
  Vector3<Number> x = start, solution = start;
  Number last(std::numeric_limits<double>::infinity());
  const auto isStarted = isFinite(start);
  auto isLeft = isStarted;
  for (int iteration = 0; iteration < kMaxIterations && isAny(isLeft); ++iteration) {
    const Vector3<Number> better = next(x);
    const Number change = largestSize(better - x);
    // An infinite change is no larger than the rounding of an infinite number.
    const auto isWithinRounding =
        both(change <= Number(kSolverRounding) * largestSize(better), isFinite(better));
    const auto isFalling = both(change<last, change> Number(0));
    const auto isDone = both(isWithinRounding, isNot(isFalling));
    solution = chosen(both(isLeft, isDone), better, solution);
    isLeft = both(isLeft, isNot(isDone));
    x = better;
    last = change;
  }
  return Iterated<Number, decltype(isLeft)>{solution, both(isStarted, isNot(isLeft))};
}

}  // namespace rotatebook::physics
