// Reciprocal roots of numbers whose products and sums are rounded once. Inside the room only.
#pragma once

namespace rotatebook::study::lanes {

/// Returns the rounded 1/y of the rounded y = sqrt(x), for 1e-4 < |x - 1| <= kRootReach and the
/// series of inverseRoot(), in a third of the time of a root and a division. Newton's steps, as in
/// Markstein, "Computation of elementary functions on the IBM RISC System/6000 processor" (1990),
/// but from the series; before they are rounded, root and reciprocal are right to 2^-101.
template <typename Number>
requires requires(Number number) {
  fusedSum(number, number, number);
}
[[gnu::always_inline]] inline Number inverseOfRoot(Number x, Number series) {
  const Number one(1), half(0.5), e = x - one, square = e * e;
  const Number start = fusedSum(square * square, Number(35.0 / 128), series);
  const Number root0 = x * start, half0 = half * start;
  const Number rest = fusedRest(root0, half0, half);
  const Number root1 = fusedSum(root0, rest, root0), half1 = fusedSum(half0, rest, half0);
  const Number root = fusedSum(fusedRest(root1, root1, x), half1, root1);
  const Number inverse = half1 + half1;
  return fusedSum(inverse, fusedRest(root, inverse, one), inverse);
}

}  // namespace rotatebook::study::lanes
