#include "physics/elementary.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rotatebook::physics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Under it sine, tangent and their inverses differ from their argument by less than half of its
// last place.
constexpr double kTiny = 0x1p-27;

constexpr DoubleDouble kLog2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

// A number in pieces: the products of the first three with whole numbers under 2^26 are exact.
struct Pieces {
  std::array<double, 3> first;
  DoubleDouble rest;
};

constexpr int kTurnParts = 128;
constexpr Pieces kTurnPart{{0x1.921fb54p-5, 0x1.10b461p-35, 0x1.a62633p-63},
                           {0x1.45c06e0e68948p-91, 0x1.27044533e63ap-147}};  // pi/64
constexpr double kTurnPartsPerRadian = 20.371832715762603;

constexpr int kOctaveParts = 64;
constexpr Pieces kOctavePart{{0x1.62e42fcp-7, 0x1.7d1cf78p-34, 0x1.abc9e38p-62},
                             {0x1.9cc01f97b57ap-89, 0x1.e6864ce5316c6p-143}};  // ln(2)/64
constexpr double kOctavePartsPerUnit = 92.33248261893658;

// The nearest whole number, of less than 2^51: a function of the C library is slower.
double nearest(double x) {
  constexpr double kShift = 0x1.8p52;
  return (x + kShift) - kShift;
}

// x - count part, good to 2^-100 of itself however much cancels: no double under 1e6 is nearer to a
// multiple of pi/64 than 2^-65.
DoubleDouble reduced(DoubleDouble x, double count, const Pieces& part) {
  if (count == 0) return x;
  const DoubleDouble first = exactSum(x.high - count * part.first[0], -count * part.first[1]);
  const DoubleDouble second = first - DoubleDouble(count * part.first[2]);
  return second + (DoubleDouble(x.low) - part.rest * count);
}

// c0 + x (c1 + x (c2 + ...)) in doubles.
template <std::size_t kCount>
double polynomial(double x, const std::array<double, kCount>& coefficients) {
  double sum = 0;
  for (std::size_t i = kCount; i-- > 0;) sum = coefficients[i] + x * sum;
  return sum;
}

constexpr DoubleDouble inverse(double n) {
  return DoubleDouble(1.0) / n;
}

struct Turn {
  DoubleDouble cosine, sine;
};

// Taylor's series for |x| <= pi/4.
constexpr Turn taylor(DoubleDouble x) {
  const DoubleDouble xx = x * x;
  Turn turn{1.0, 1.0};
  for (int n = 28; n > 0; n -= 2) {
    turn.cosine = DoubleDouble(1.0) - xx * turn.cosine / ((n - 1.0) * n);
    turn.sine = DoubleDouble(1.0) - xx * turn.sine / (n * (n + 1.0));
  }
  return {turn.cosine, x * turn.sine};
}

// Of a part of a turn. What isn't within pi/4 of 0 follows by reflection, so that zeros are exact.
constexpr Turn turnOf(int part) {
  constexpr int kQuarter = kTurnParts / 4;
  const int rest = part % kQuarter;
  const bool isNear = rest <= kQuarter / 2;
  Turn turn = taylor(kPi * (2.0 / kTurnParts * (isNear ? rest : kQuarter - rest)));
  if (!isNear) turn = {turn.sine, turn.cosine};
  for (int quarter = part / kQuarter; quarter > 0; --quarter) turn = {-turn.sine, turn.cosine};
  return turn;
}

// 2^(part/64), by the exponential's series.
constexpr DoubleDouble powerOf(int part) {
  const DoubleDouble x = kLog2 * (1.0 / kOctaveParts * part);
  DoubleDouble power = 1.0;
  for (int n = 28; n > 0; --n) power = DoubleDouble(1.0) + x * power / n;
  return power;
}

template <typename Value, std::size_t kCount>
constexpr std::array<Value, kCount> tableOf(Value (*valueOf)(int)) {
  std::array<Value, kCount> table{};
  for (std::size_t i = 0; i < kCount; ++i) table[i] = valueOf(static_cast<int>(i));
  return table;
}

// Filled by the compiler.
constexpr auto kTurns = tableOf<Turn, kTurnParts>(turnOf);
constexpr auto kPowers = tableOf<DoubleDouble, kOctaveParts>(powerOf);

constexpr const Turn& turnAt(int part) {
  return kTurns[static_cast<std::size_t>(part & (kTurnParts - 1))];
}

// cos x - 1 and sin x for |x| <= pi/128: the first two terms of the series in pairs, the rest, which
// is under 2^-41 of the sum, in doubles.
Turn smallTurn(DoubleDouble x) {
  constexpr DoubleDouble kThird = -inverse(6), kFifth = inverse(120);
  constexpr DoubleDouble kFourth = inverse(24);
  const DoubleDouble xx = x * x;
  const double t = xx.high;
  const double sine = t * polynomial(t, std::array{-1.0 / 5040, 1.0 / 362880, -1.0 / 39916800,
                                                   1.0 / 6227020800});
  const double cosine = t * polynomial(t, std::array{-1.0 / 720, 1.0 / 40320, -1.0 / 3628800,
                                                     1.0 / 479001600});
  const DoubleDouble sineFactor =
      xx * dominantSum(kThird, xx * dominantSum(kFifth, sine));
  return {xx * dominantSum(-0.5, xx * dominantSum(kFourth, cosine)),
          dominantSum(x, x * sineFactor)};
}

// Cosine and sine of an angle within kLargestAngle.
Turn cosineSineOf(DoubleDouble angle) {
  const double part = nearest(angle.high * kTurnPartsPerRadian);
  const Turn small = smallTurn(reduced(angle, part, kTurnPart));
  const Turn& base = turnAt(static_cast<int>(part));
  return {base.cosine - base.sine * small.sine + base.cosine * small.cosine,
          base.sine + base.cosine * small.sine + base.sine * small.cosine};
}

// The arc tangent of |x| < 0.03; the rest of the series from the fifth term on in doubles.
DoubleDouble smallArcTangent(DoubleDouble x) {
  constexpr DoubleDouble kThird = -inverse(3), kFifth = inverse(5), kSeventh = -inverse(7);
  const DoubleDouble xx = x * x;
  const double t = xx.high;
  const double rest = t * polynomial(t, std::array{1.0 / 9, -1.0 / 11, 1.0 / 13, -1.0 / 15,
                                                   1.0 / 17, -1.0 / 19, 1.0 / 21});
  const DoubleDouble inner = dominantSum(kFifth, xx * dominantSum(kSeventh, rest));
  return dominantSum(x, x * (xx * dominantSum(kThird, xx * inner)));
}

// e^x - 1 for |x| <= ln(2)/128.
DoubleDouble smallExponential(DoubleDouble x) {
  constexpr DoubleDouble kThird = inverse(6), kFourth = inverse(24), kFifth = inverse(120);
  const double t = x.high;
  const double rest =
      t * polynomial(t, std::array{1.0 / 720, 1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800});
  const DoubleDouble inner = dominantSum(kFourth, x * dominantSum(kFifth, rest));
  return dominantSum(x, x * x * dominantSum(0.5, x * dominantSum(kThird, x * inner)));
}

// 2 artanh(x), which is the logarithm of (1 + x)/(1 - x), for |x| < 0.003.
DoubleDouble smallLogarithm(DoubleDouble x) {
  constexpr DoubleDouble kThird = inverse(3), kFifth = inverse(5);
  const DoubleDouble xx = x * x;
  const double t = xx.high;
  const double rest = t * polynomial(t, std::array{1.0 / 7, 1.0 / 9, 1.0 / 11, 1.0 / 13});
  return dominantSum(x, x * (xx * dominantSum(kThird, xx * dominantSum(kFifth, rest)))) * 2.0;
}

// value 2^exponent for value > 0, rounded once. Where the result has fewer than 53 bits the rest is
// rounded off by adding a 1 that stands above them.
double scaledDouble(DoubleDouble value, int exponent) {
  constexpr int kLowest = -1022;
  if (std::ilogb(value.high) + exponent >= kLowest) return std::ldexp(value.value(), exponent);
  const DoubleDouble small = scaled(value, exponent - kLowest);
  const DoubleDouble sum = quickSum(1, small.high);
  return std::ldexp(sum.high + (sum.low + small.low) - 1, kLowest);
}

// fraction 2^exponent
struct Power {
  DoubleDouble fraction;
  int exponent;
};

Power exponentialOf(double x) {
  const double part = nearest(x * kOctavePartsPerUnit);
  const int count = static_cast<int>(part);
  const DoubleDouble base = kPowers[static_cast<std::size_t>(count & (kOctaveParts - 1))];
  const DoubleDouble small = smallExponential(reduced(x, part, kOctavePart));
  return {dominantSum(base, base * small), (count - (count & (kOctaveParts - 1))) / kOctaveParts};
}

// e^x - 1 for |x| < 700, to as many digits near 0.
DoubleDouble exponentialLessOne(double x) {
  if (std::fabs(x) * kOctavePartsPerUnit < 0.5) return smallExponential(x);
  const auto [fraction, exponent] = exponentialOf(x);
  return scaled(fraction, exponent) - DoubleDouble(1.0);
}

// Of the logarithm to the base 2, for 1 <= x < 2: to 2e-5.
double roughLogarithm(double x) {
  const double t = (x - 1) / (x + 1);
  return 2.88539 * t * polynomial(t * t, std::array{1.0, 1.0 / 3, 1.0 / 5, 1.0 / 7});
}

// Of x > 0.
DoubleDouble logarithmOf(DoubleDouble x) {
  int exponent = std::ilogb(x.high);
  const double rough = roughLogarithm(std::ldexp(x.high, -exponent));
  int part = static_cast<int>(nearest(rough * kOctaveParts));
  if (part == kOctaveParts) part = 0, ++exponent;
  const DoubleDouble base = kPowers[static_cast<std::size_t>(part)];
  const DoubleDouble fraction = scaled(x, -exponent);
  const double octaves = exponent + 1.0 / kOctaveParts * part;
  return dominantSum(kLog2 * octaves, smallLogarithm(quickQuotient(fraction - base, fraction + base)));
}

// Of y/x, for 0 < y <= x, both near 1 enough that nothing underflows.
DoubleDouble arcTangentOf(double y, double x) {
  constexpr double kRough = 0.273;  // atan q is q (pi/4 + 0.273 (1 - q)) to 0.004.
  const double q = y / x;
  const double rough = q * (kPi.high / 4 + kRough * (1 - q));
  const double part = nearest(rough * kTurnPartsPerRadian);
  const auto& [cosine, sine] = turnAt(static_cast<int>(part));
  const DoubleDouble t = quickQuotient(cosine * y - sine * x, cosine * x + sine * y);
  return dominantSum(kPi * (2.0 / kTurnParts * part), smallArcTangent(t));
}

}  // namespace

double sine(double x) {
  if (std::fabs(x) < kTiny) return x;
  return std::fabs(x) <= kLargestAngle ? cosineSineOf(x).sine.value() : kNaN;
}

double cosine(double x) {
  return std::fabs(x) <= kLargestAngle ? cosineSineOf(x).cosine.value() : kNaN;
}

CosineSine cosineSine(DoubleDouble angle) {
  if (!(std::fabs(angle.high) <= kLargestAngle)) return {kNaN, kNaN};
  const auto [cosine, sine] = cosineSineOf(angle);
  return {cosine.value(), sine.value()};
}

double arcTangent(double x) {
  return std::fabs(x) < kTiny ? x : arcTangent(x, 1);
}

double arcTangent(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  double across = std::fabs(y), along = std::fabs(x);
  // What is infinite is far longer than what isn't; of two the same length counts, as of two zeros.
  if (std::isinf(along) || std::isinf(across)) {
    along = std::isinf(along) ? 1 : 0;
    across = std::isinf(across) ? 1 : 0;
  }
  const bool isSteep = across > along;
  const double small = isSteep ? along : across, large = isSteep ? across : along;

  // The angle to the nearer axis
  DoubleDouble angle = 0.0;
  if (small > 0) {
    const int exponent = std::ilogb(large), fall = std::ilogb(small) - exponent;
    const double y1 = std::ldexp(small, -exponent - fall), x1 = std::ldexp(large, -exponent);
    if (fall > -60) {
      angle = arcTangentOf(std::ldexp(y1, fall), x1);
    } else {
      // Hardly less than the ratio, which decides where that is half of the lowest place.
      const DoubleDouble ratio = DoubleDouble(y1) / x1;
      const DoubleDouble less = ratio - ratio * 0x1p-106;
      if (!isSteep && x > 0) return std::copysign(scaledDouble(less, fall), y);
      angle = scaled(ratio, fall);
    }
  }
  if (isSteep) angle = kPi * 0.5 - angle;
  if (std::signbit(x)) angle = kPi - angle;
  return std::copysign(angle.value(), y);
}

double exponential(double x) {
  constexpr double kHighest = 710, kLowest = -746;
  if (std::isnan(x)) return kNaN;
  if (x > kHighest) return kInfinity;
  if (x < kLowest) return 0;
  const auto [fraction, exponent] = exponentialOf(x);
  return scaledDouble(fraction, exponent);
}

double logarithm(double x) {
  if (std::isnan(x) || x < 0) return kNaN;
  if (x == 0) return -kInfinity;
  return std::isinf(x) ? x : logarithmOf(x).value();
}

double hyperbolicTangent(double x) {
  constexpr double kOne = 20;  // where it is 1 to rounding
  const double size = std::fabs(x);
  if (size < kTiny || std::isnan(x)) return x;
  if (size > kOne) return std::copysign(1, x);
  const DoubleDouble power = exponentialLessOne(2 * size);
  return std::copysign((power / (power + 2.0)).value(), x);
}

double inverseHyperbolicSine(double x) {
  constexpr double kSmall = 0x1p-9, kLarge = 0x1p60;
  const double size = std::fabs(x);
  if (size < kTiny || !std::isfinite(x)) return x;
  if (size > kLarge) return std::copysign((logarithmOf(size) + kLog2).value(), x);
  const DoubleDouble square = exactProduct(size, size);
  const DoubleDouble root = squareRoot(square + 1.0);
  if (size > kSmall) return std::copysign(logarithmOf(root + size).value(), x);
  const DoubleDouble lessOne = square / (root + 1.0) + size;
  return std::copysign(smallLogarithm(lessOne / (lessOne + 2.0)).value(), x);
}

double roundedHypotenuse(double x, double y) {
  if (std::isinf(x) || std::isinf(y)) return kInfinity;
  const double larger = std::fmax(std::fabs(x), std::fabs(y));
  if (std::isnan(x) || std::isnan(y) || larger == 0) return std::fabs(x + y);
  const int exponent = std::ilogb(larger);
  const double a = std::ldexp(x, -exponent), b = std::ldexp(y, -exponent);
  return scaledDouble(squareRoot(exactProduct(a, a) + exactProduct(b, b)), exponent);
}

}  // namespace rotatebook::physics
