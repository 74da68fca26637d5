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

/// Returns whether the size of any number is above `bound`.
inline bool isAnyLarger(double x, double bound) {
  return std::fabs(x) > bound;
}
/// Returns a b + c, where a b has no more digits than a number: however often it is rounded.
inline double exactProductPlus(double a, double b, double c) {
  return a * b + c;
}

/// Distance from 1 up to which inverseRoot() is that of the series.
inline constexpr double kNearOne = 1e-4;  // The next term of the series is below 3e-17 here.
/// Distance from 1 up to which a type's inverseOfRoot() is right, if it has one.
inline constexpr double kRootReach = 0x1p-5;

/// Returns inverseRoot() of numbers that are all near 1.
template <typename Number>
[[gnu::always_inline]] inline Number inverseRootNearOne(Number x) {
  const Number e = x - Number(1);
  return exactProductPlus(Number(-0.5), e, Number(1)) +
         e * e * exactProductPlus(Number(-0.3125), e, Number(0.375));
}
/// Returns inverseRoot() of numbers that are all farther from 1, but within kRootReach.
template <typename Number>
[[gnu::always_inline]] inline Number inverseRootFarFromOne(Number x) {
  if constexpr (requires { inverseOfRoot(x, x); }) {
    return inverseOfRoot(x, inverseRootNearOne(x));
  } else {
    return Number(1) / rootOf(x);
  }
}

/// Returns 1/sqrt(x), to rounding. Near 1, where the squared norm of an attitude is after a short
/// step, a series is faster than a root and a division. There x - 1 has at most 40 digits.
template <typename Number>
[[gnu::always_inline]] inline Number inverseRoot(Number x) {
  const Number e = x - Number(1);
  const Number series = inverseRootNearOne(x);
  if (!isAnyLarger(e, kNearOne)) [[likely]]
    return series;
  const auto isFar = magnitude(e) > Number(kNearOne);
  if constexpr (requires { inverseOfRoot(x, series); }) {
    if (!isAnyLarger(e, kRootReach)) [[likely]]
      return chosen(isFar, inverseOfRoot(x, series), series);
  }
  return chosen(isFar, Number(1) / rootOf(x), series);
}

}  // namespace rotatebook::physics
