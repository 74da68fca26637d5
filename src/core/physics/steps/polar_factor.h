// The nearest orthogonal matrix, of any type of number.
#pragma once

#include "physics/steps/number.h"
#include "physics/steps/vector.h"

namespace rotatebook::physics {

/// Takes the orthogonal matrix closest to `map`, bit by bit as rigid::polarFactor() does. Newton's
/// iteration X <- (X + X^-T)/2, for each body until it has converged; `rest(map, solution, isLeft)`
/// returns the solutions, with those for which that takes too long.
template <typename Number, typename Rest>
[[gnu::always_inline]] inline void takePolarFactor(Matrix3<Number>& map, const Rest& rest) {
  constexpr int kMaxSteps = 12;
  constexpr double kSmallLastStep = 1e-9;
  Matrix3<Number> x = map, solution = map;
  auto isLeft = Number(0) == Number(0);
  for (int step = 0; step < kMaxSteps && isAny(isLeft); ++step) {
    const Matrix3<Number> cofactors{cross(x.y, x.z), cross(x.z, x.x), cross(x.x, x.y)};
    const Number determinant = dot(x.x, cofactors.x);
    const Matrix3<Number> change{Number(0.5) * (cofactors.x / determinant - x.x),
                                 Number(0.5) * (cofactors.y / determinant - x.y),
                                 Number(0.5) * (cofactors.z / determinant - x.z)};
    x = {x.x + change.x, x.y + change.y, x.z + change.z};
    const auto isDone =
        both(isWithin(change.x, kSmallLastStep),
             both(isWithin(change.y, kSmallLastStep), isWithin(change.z, kSmallLastStep)));
    solution = chosen(both(isLeft, isDone), x, solution);
    isLeft = both(isLeft, isNot(isDone));
  }
  map = isAny(isLeft) ? rest(map, solution, isLeft) : solution;
}

}  // namespace rotatebook::physics
