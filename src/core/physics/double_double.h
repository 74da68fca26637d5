// Numbers of twice a double's precision, for the constants of a motion.
#pragma once

#include <cmath>

namespace rotatebook::physics {

/// The unevaluated sum of two doubles, `low` at most half a unit in the last place of `high`: 106
/// bits, in a double's range. Each operation below is good to a few 1e-32 of its result (Dekker
/// 1971; Hida, Li and Bailey 2001), as long as nothing under 1e-290 is rounded.
struct DoubleDouble {
  double high = 0;
  double low = 0;

  constexpr DoubleDouble() = default;
  /// Not explicit: every double is such a number.
  constexpr DoubleDouble(double value) : high(value) {}
  constexpr DoubleDouble(double h, double l) : high(h), low(l) {}

  /// The nearest double.
  constexpr double value() const { return high + low; }
};

/// a + b without error.
inline DoubleDouble exactSum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// a b without error.
inline DoubleDouble exactProduct(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

inline DoubleDouble operator-(DoubleDouble a) {
  return {-a.high, -a.low};
}

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = exactSum(a.high, b.high);
  const DoubleDouble low = exactSum(a.low, b.low);
  const DoubleDouble sum = exactSum(high.high, high.low + low.high);
  return exactSum(sum.high, sum.low + low.low);
}

inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
  return a + -b;
}

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = exactProduct(a.high, b.high);
  return exactSum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * first;
  const double second = rest.high / b.high;
  const double third = (rest - b * second).high / b.high;
  return DoubleDouble(first) + (DoubleDouble(second) + third);
}

/// Root of `a` >= 0.
inline DoubleDouble squareRoot(DoubleDouble a) {
  if (a.high <= 0) return 0.0;
  const double root = std::sqrt(a.high);
  const DoubleDouble rest = a - exactProduct(root, root);
  return exactSum(root, rest.high / (2 * root));
}

inline DoubleDouble absolute(DoubleDouble a) {
  return a.high < 0 ? -a : a;
}

/// a 2^exponent.
inline DoubleDouble scaled(DoubleDouble a, int exponent) {
  return {std::ldexp(a.high, exponent), std::ldexp(a.low, exponent)};
}

/// The largest power of two that is no larger than `number` > 0.
inline double powerOfTwoBelow(double number) {
  return std::ldexp(1, std::ilogb(number));
}

/// sqrt(a^2 + b^2), also where the squares would underflow.
inline DoubleDouble hypotenuse(DoubleDouble a, DoubleDouble b) {
  const double larger = std::fmax(std::fabs(a.high), std::fabs(b.high));
  if (larger == 0) return 0.0;
  const int exponent = std::ilogb(larger);
  const DoubleDouble x = scaled(a, -exponent);
  const DoubleDouble y = scaled(b, -exponent);
  return scaled(squareRoot(x * x + y * y), exponent);
}

}  // namespace rotatebook::physics
