// Numbers that steps compute with: a double, or a type that holds several of them, one for each of
// several bodies. Steps are templates of it, and so have one source for one body and for many at
// once. They call these functions for what differs: comparisons, which give a bool for a double
// and a mask for several. What isn't a template here serves doubles alone.
#pragma once

#include <cmath>

namespace rotatebook::physics {

/// Returns whether a condition holds for any body, or for all; and for which bodies it doesn't, or
/// both do.
inline bool isAny(bool condition) {
  return condition;
}
inline bool isAll(bool condition) {
  return condition;
}
inline bool isNot(bool condition) {
  return !condition;
}
inline bool both(bool a, bool b) {
  return a && b;
}
/// Returns, body by body, `yes` where `condition` holds and else `no`.
inline double chosen(bool condition, double yes, double no) {
  return condition ? yes : no;
}
inline double magnitude(double x) {
  return std::fabs(x);
}
inline double rootOf(double x) {
  return std::sqrt(x);
}

/// Returns 1/sqrt(x), to rounding. Near 1, where the squared norm of an attitude is after a short
/// step, a series is faster than a root and a division.
template <typename Number>
[[gnu::always_inline]] inline Number inverseRoot(Number x) {
  const Number kNearOne(1e-4);  // The next term of the series is below 3e-17 here.
  const Number e = x - Number(1);
  const auto isFar = magnitude(e) > kNearOne;
  const Number near = (Number(1) - e / Number(2)) + e * e * (Number(0.375) - Number(0.3125) * e);
  if (!isAny(isFar)) [[likely]]
    return near;
  return chosen(isFar, Number(1) / rootOf(x), near);
}

}  // namespace rotatebook::physics
