// Double-double numbers: twice a double's precision, for the constants of a motion.
#pragma once

#include <array>
#include <cmath>

namespace rotatebook {

/// The unevaluated sum of two doubles, `low` at most half a unit in the last place of `high`: 106
/// bits, in a double's range. Each operation below is accurate to a few 1e-32 of its result (Dekker
/// 1971; Hida, Li and Bailey 2001), as long as nothing below 1e-290 is rounded.
struct DoubleDouble {
  double high = 0;
  double low = 0;

  constexpr DoubleDouble() = default;
  /// Implicit, because every double is a double-double number.
  constexpr DoubleDouble(double value) : high(value) {}
  constexpr DoubleDouble(double h, double l) : high(h), low(l) {}

  /// Returns the nearest double.
  constexpr double value() const { return high + low; }
};

/// Components along the three axes of a reference frame.
using DoubleDouble3 = std::array<DoubleDouble, 3>;

/// Returns a + b without error. (Two-sum; Knuth 1969)
constexpr DoubleDouble exactSum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// Returns a + b without error, where a is 0 or |a| >= |b|. (Fast two-sum; Dekker 1971)
constexpr DoubleDouble quickSum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// Splits `a` into two numbers of 26 bits each, for |a| under 1e300. (Veltkamp 1968)
constexpr DoubleDouble halves(double a) {
  const double shifted = 134217729 * a;  // 2^27 + 1
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

/// Returns a b without error, where no part of it is under 1e-300. Multiplies halves, because not
/// every processor has a fused multiply-add. (Dekker 1971)
constexpr DoubleDouble exactProduct(double a, double b) {
  const double product = a * b;
  const DoubleDouble x = halves(a), y = halves(b);
  return {product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

constexpr DoubleDouble operator-(DoubleDouble a) {
  return {-a.high, -a.low};
}

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = exactSum(a.high, b.high);
  const DoubleDouble low = exactSum(a.low, b.low);
  const DoubleDouble sum = exactSum(high.high, high.low + low.high);
  return exactSum(sum.high, sum.low + low.low);
}

constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
  return a + -b;
}

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = exactProduct(a.high, b.high);
  return quickSum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * first;
  const double second = rest.high / b.high;
  const double third = (rest - b * second).high / b.high;
  return DoubleDouble(first) + (DoubleDouble(second) + third);
}

/// Returns a + b in half the operator's time, where a is 0 or |a| >= 2 |b|.
constexpr DoubleDouble dominantSum(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = quickSum(a.high, b.high);
  return quickSum(high.high, high.low + (a.low + b.low));
}

/// Returns a / b to 2^-100 of itself, in half the operator's time.
constexpr DoubleDouble quickQuotient(DoubleDouble a, DoubleDouble b) {
  const double first = a.high / b.high;
  const DoubleDouble product = exactProduct(first, b.high);
  const double rest = ((a.high - product.high) - product.low) + (a.low - first * b.low);
  return quickSum(first, rest / b.high);
}

/// Returns the square root of `a` >= 0.
inline DoubleDouble squareRoot(DoubleDouble a) {
  if (a.high <= 0) return 0.0;
  const double root = std::sqrt(a.high);
  const DoubleDouble rest = a - exactProduct(root, root);
  return exactSum(root, rest.high / (2 * root));
}

constexpr bool operator<(DoubleDouble a, DoubleDouble b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
constexpr bool operator==(DoubleDouble a, DoubleDouble b) {
  return a.high == b.high && a.low == b.low;
}

inline DoubleDouble absolute(DoubleDouble a) {
  return a.high < 0 ? -a : a;
}

/// Returns a 2^exponent.
inline DoubleDouble scaled(DoubleDouble a, int exponent) {
  return {std::ldexp(a.high, exponent), std::ldexp(a.low, exponent)};
}

/// Returns the largest power of two that is no larger than `number` > 0.
inline double powerOfTwoBelow(double number) {
  return std::ldexp(1, std::ilogb(number));
}

/// Returns sqrt(a^2 + b^2), even where the squares would underflow.
inline DoubleDouble hypotenuse(DoubleDouble a, DoubleDouble b) {
  const double larger = std::fmax(std::fabs(a.high), std::fabs(b.high));
  if (larger == 0) return 0.0;
  const int exponent = std::ilogb(larger);
  const DoubleDouble x = scaled(a, -exponent);
  const DoubleDouble y = scaled(b, -exponent);
  return scaled(squareRoot(x * x + y * y), exponent);
}

}  // namespace rotatebook
