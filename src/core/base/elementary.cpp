#include "base/elementary.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace rotatebook {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Below this, sine, tangent and their inverses differ from their argument by less than half a unit
// in its last place.
constexpr double kTiny = 0x1p-27;

// Error of sums and products of double-double numbers near 1.
constexpr double kPairError = 0x1p-98;

constexpr DoubleDouble kLog2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

// A constant in pieces: the products of the first three with integers under 2^26 are exact.
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

constexpr int kTangentParts = 256;

// Rounds to the nearest integer, for |x| < 2^51, faster than the C library's function.
double nearest(double x) {
  constexpr double kShift = 0x1.8p52;
  return (x + kShift) - kShift;
}

// Returns x - count part, accurate to 2^-90 of itself however much cancels: no double is closer to
// a multiple of pi/2 than 2^-61, and so none to a multiple of pi/64 than 2^-66. (Kahan 1983)
DoubleDouble reduced(DoubleDouble x, double count, const Pieces& part) {
  if (count == 0) return x;
  const DoubleDouble first = exactSum(x.high - count * part.first[0], -count * part.first[1]);
  const DoubleDouble second = first - DoubleDouble(count * part.first[2]);
  return second + (DoubleDouble(x.low) - part.rest * count);
}

// Returns c0 + x (c1 + x (c2 + ...)) in doubles.
template <std::size_t kCount>
double polynomial(double x, const std::array<double, kCount>& coefficients) {
  double sum = 0;
  for (std::size_t i = kCount; i-- > 0;) sum = coefficients[i] + x * sum;
  return sum;
}

// Returns high + low, rounded, if the result is the same for every `low` within its error.
std::optional<double> roundedIfSure(double high, double low, double error) {
  const double above = high + (low + error), below = high + (low - error);
  return above == below ? std::optional(above) : std::nullopt;
}

constexpr DoubleDouble inverse(double n) {
  return DoubleDouble(1.0) / n;
}

struct Turn {
  DoubleDouble cosine, sine;
};

// Sums Taylor's series of cosine and sine for |x| <= pi/4.
constexpr Turn taylor(DoubleDouble x) {
  const DoubleDouble xx = x * x;
  Turn turn{1.0, 1.0};
  for (int n = 28; n > 0; n -= 2) {
    turn.cosine = DoubleDouble(1.0) - xx * turn.cosine / ((n - 1.0) * n);
    turn.sine = DoubleDouble(1.0) - xx * turn.sine / (n * (n + 1.0));
  }
  return {turn.cosine, x * turn.sine};
}

// Returns cosine and sine of `part` 128ths of a turn. Those of angles farther than pi/4 from a
// quarter turn's start follow by reflection, so that zeros are exact.
constexpr Turn turnOf(int part) {
  constexpr int kQuarter = kTurnParts / 4;
  const int rest = part % kQuarter;
  const bool isNear = rest <= kQuarter / 2;
  Turn turn = taylor(kPi * (2.0 / kTurnParts * (isNear ? rest : kQuarter - rest)));
  if (!isNear) turn = {turn.sine, turn.cosine};
  for (int quarter = part / kQuarter; quarter > 0; --quarter) turn = {-turn.sine, turn.cosine};
  return turn;
}

// Returns 2^(part/64), from the exponential's series.
constexpr DoubleDouble powerOf(int part) {
  const DoubleDouble x = kLog2 * (1.0 / kOctaveParts * part);
  DoubleDouble power = 1.0;
  for (int n = 28; n > 0; --n) power = DoubleDouble(1.0) + x * power / n;
  return power;
}

// Returns atan(part/256) from the arc tangent of the part before: their difference is the arc
// tangent of a number under 1/256, summed by Taylor's series.
constexpr DoubleDouble arcTangentAfter(DoubleDouble before, int part) {
  const DoubleDouble x =
      DoubleDouble(kTangentParts) / (double{kTangentParts} * kTangentParts + part * (part - 1.0));
  DoubleDouble sum = 0.0;
  for (int n = 19; n > 0; n -= 2) sum = inverse(n) - x * x * sum;
  return before + x * sum;
}

constexpr std::array<DoubleDouble, kTangentParts + 1> arcTangentTable() {
  std::array<DoubleDouble, kTangentParts + 1> table{};
  for (std::size_t i = 1; i < table.size(); ++i) {
    table[i] = arcTangentAfter(table[i - 1], static_cast<int>(i));
  }
  return table;
}

template <typename Value, std::size_t kCount>
constexpr std::array<Value, kCount> tableOf(Value (*valueOf)(int)) {
  std::array<Value, kCount> table{};
  for (std::size_t i = 0; i < kCount; ++i) table[i] = valueOf(static_cast<int>(i));
  return table;
}

// Tables that the compiler computes.
constexpr auto kTurns = tableOf<Turn, kTurnParts>(turnOf);
constexpr auto kPowers = tableOf<DoubleDouble, kOctaveParts>(powerOf);
constexpr auto kArcTangents = arcTangentTable();

constexpr const Turn& turnAt(int part) {
  return kTurns[static_cast<std::size_t>(part & (kTurnParts - 1))];
}

// Returns cos x - 1 and sin x for |x| <= pi/128: the first two terms of each series in
// double-double, the rest, which is under 2^-41 of the sum, in doubles.
Turn smallTurn(DoubleDouble x) {
  constexpr DoubleDouble kThird = -inverse(6), kFifth = inverse(120);
  constexpr DoubleDouble kFourth = inverse(24);
  const DoubleDouble xx = x * x;
  const double t = xx.high;
  const double sine =
      t * polynomial(t, std::array{-1.0 / 5040, 1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800});
  const double cosine =
      t * polynomial(t, std::array{-1.0 / 720, 1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600});
  const DoubleDouble sineFactor = xx * dominantSum(kThird, xx * dominantSum(kFifth, sine));
  return {xx * dominantSum(-0.5, xx * dominantSum(kFourth, cosine)),
          dominantSum(x, x * sineFactor)};
}

// Returns cosine and sine of an angle within kLargestAngle.
Turn cosineSineOf(DoubleDouble angle) {
  const double part = nearest(angle.high * kTurnPartsPerRadian);
  const Turn small = smallTurn(reduced(angle, part, kTurnPart));
  const Turn& base = turnAt(static_cast<int>(part));
  return {base.cosine - base.sine * small.sine + base.cosine * small.cosine,
          base.sine + base.cosine * small.sine + base.sine * small.cosine};
}

// Returns the arc tangent of |x| <= 1/512.
DoubleDouble smallArcTangent(DoubleDouble x) {
  constexpr DoubleDouble kThird = -inverse(3);
  const DoubleDouble xx = x * x;
  const double t = xx.high;
  const double rest = t * polynomial(t, std::array{1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11});
  return dominantSum(x, x * (xx * dominantSum(kThird, rest)));
}

// Returns e^x - 1 for |x| <= ln(2)/128.
DoubleDouble smallExponential(DoubleDouble x) {
  constexpr DoubleDouble kThird = inverse(6), kFourth = inverse(24), kFifth = inverse(120);
  const double t = x.high;
  const double rest = t * polynomial(t, std::array{1.0 / 720, 1.0 / 5040, 1.0 / 40320, 1.0 / 362880,
                                                   1.0 / 3628800});
  const DoubleDouble inner = dominantSum(kFourth, x * dominantSum(kFifth, rest));
  return dominantSum(x, x * x * dominantSum(0.5, x * dominantSum(kThird, x * inner)));
}

// Returns 2 artanh(x), the logarithm of (1 + x)/(1 - x), for |x| < 0.003.
DoubleDouble smallLogarithm(DoubleDouble x) {
  constexpr DoubleDouble kThird = inverse(3), kFifth = inverse(5);
  const DoubleDouble xx = x * x;
  const double t = xx.high;
  const double rest = t * polynomial(t, std::array{1.0 / 7, 1.0 / 9, 1.0 / 11, 1.0 / 13});
  return dominantSum(x, x * (xx * dominantSum(kThird, xx * dominantSum(kFifth, rest)))) * 2.0;
}

// Returns value 2^exponent for value > 0, rounded once. Where the result has fewer than 53 bits,
// adding a 1 above them rounds the rest off.
double scaledDouble(DoubleDouble value, int exponent) {
  constexpr int kLowest = -1022;
  if (std::ilogb(value.high) + exponent >= kLowest) return std::ldexp(value.value(), exponent);
  const DoubleDouble small = scaled(value, exponent - kLowest);
  const DoubleDouble sum = quickSum(1, small.high);
  const DoubleDouble rest = exactSum(sum.low, small.low);
  // Let what is cut off decide where the rest is halfway between two results
  const double nudged =
      rest.low == 0 ? rest.high : std::nextafter(rest.high, rest.low > 0 ? kInfinity : -kInfinity);
  return std::ldexp(sum.high + nudged - 1, kLowest);
}

// The number fraction 2^exponent.
struct Power {
  DoubleDouble fraction;
  int exponent;
};

constexpr int octaveOf(int part) {
  return (part - (part & (kOctaveParts - 1))) / kOctaveParts;
}

Power exponentialOf(double x) {
  const double count = nearest(x * kOctavePartsPerUnit);
  const int part = static_cast<int>(count);
  const DoubleDouble& base = kPowers[static_cast<std::size_t>(part & (kOctaveParts - 1))];
  const DoubleDouble small = smallExponential(reduced(x, count, kOctavePart));
  return {dominantSum(base, base * small), octaveOf(part)};
}

// Returns e^x from doubles alone if they decide its rounding, as they usually do; else nullopt.
std::optional<double> quickExponential(double x) {
  constexpr double kQuickError = 0x1p-57;  // six roundings of |r| < 2^-7.5
  constexpr double kNormal = 700;
  if (std::fabs(x) > kNormal) return std::nullopt;
  const double count = nearest(x * kOctavePartsPerUnit);
  const int part = static_cast<int>(count);
  const DoubleDouble& base = kPowers[static_cast<std::size_t>(part & (kOctaveParts - 1))];
  const auto& [first, second, third] = kOctavePart.first;
  const double r = ((x - count * first) - count * second) - count * third;
  const double small =
      r + r * r * polynomial(r, std::array{1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720});
  const auto sure = roundedIfSure(base.high, base.low + base.high * small, base.high * kQuickError);
  return sure ? std::optional(std::ldexp(*sure, octaveOf(part))) : std::nullopt;
}

// Returns e^x - 1 for |x| < 700, without losing digits near 0.
DoubleDouble exponentialLessOne(double x) {
  if (std::fabs(x) * kOctavePartsPerUnit < 0.5) return smallExponential(x);
  const auto [fraction, exponent] = exponentialOf(x);
  return scaled(fraction, exponent) - DoubleDouble(1.0);
}

// Returns the logarithm to base 2 of 1 <= x < 2, to 2e-5.
double roughLogarithm(double x) {
  const double t = (x - 1) / (x + 1);
  return 2.88539 * t * polynomial(t * t, std::array{1.0, 1.0 / 3, 1.0 / 5, 1.0 / 7});
}

// Returns the natural logarithm of x > 0.
DoubleDouble logarithmOf(DoubleDouble x) {
  int exponent = std::ilogb(x.high);
  const double rough = roughLogarithm(std::ldexp(x.high, -exponent));
  int part = static_cast<int>(nearest(rough * kOctaveParts));
  if (part == kOctaveParts) part = 0, ++exponent;
  const DoubleDouble base = kPowers[static_cast<std::size_t>(part)];
  const DoubleDouble fraction = scaled(x, -exponent);
  const double octaves = exponent + 1.0 / kOctaveParts * part;
  return dominantSum(kLog2 * octaves,
                     smallLogarithm(quickQuotient(fraction - base, fraction + base)));
}

// One eighth of a turn: its angles are offset + sign atan(y/x) for 0 <= y <= x.
struct Octant {
  DoubleDouble offset;
  double sign;
};

// Returns the angle of (x, y) in `octant`; both are close enough to 1 that nothing underflows.
double angleIn(const Octant& octant, double y, double x) {
  constexpr double kQuickError = 0x1p-50;  // of t, for five roundings
  const double part = nearest(y / x * kTangentParts);
  const double base = part / kTangentParts;
  const DoubleDouble along = exactProduct(x, base);
  // Exact, because both numbers are close to each other.
  const DoubleDouble rise = exactSum(y - along.high, -along.low);
  const DoubleDouble run = dominantSum(x, exactProduct(y, base));
  const DoubleDouble start =
      octant.offset + kArcTangents[static_cast<std::size_t>(part)] * octant.sign;

  // Try doubles first, which usually suffice
  const double t = octant.sign * rise.high / run.high, tt = t * t;
  const double low = start.low + (t + t * tt * (-1.0 / 3 + tt * 0.2));
  const auto sure = roundedIfSure(start.high, low, kQuickError * std::fabs(t) + kPairError);
  if (sure) return *sure;

  return (start + smallArcTangent(quickQuotient(rise, run)) * octant.sign).value();
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
  constexpr int kSmallFall = -60;
  double across = std::fabs(y), along = std::fabs(x);
  // An infinite leg dwarfs a finite one; two infinite legs count as equally long, as two zeros do.
  if (std::isinf(along) || std::isinf(across)) {
    along = std::isinf(along) ? 1 : 0;
    across = std::isinf(across) ? 1 : 0;
  }
  const bool isSteep = across > along;
  const double small = isSteep ? along : across, large = isSteep ? across : along;

  const Octant octant{isSteep           ? kPi * 0.5
                      : std::signbit(x) ? kPi
                                        : DoubleDouble(0.0),
                      isSteep == std::signbit(x) ? 1.0 : -1.0};
  if (small == 0) return std::copysign(octant.offset.value(), y);
  const int exponent = std::ilogb(large), fall = std::ilogb(small) - exponent;
  const double y1 = std::ldexp(small, -exponent - fall), x1 = std::ldexp(large, -exponent);
  if (fall > kSmallFall) return std::copysign(angleIn(octant, std::ldexp(y1, fall), x1), y);

  // The angle is a hair below the ratio, which decides where that is halfway between two results
  const DoubleDouble ratio = DoubleDouble(y1) / x1;
  const DoubleDouble angle = ratio - ratio * 0x1p-106;
  return std::copysign(octant.offset.high == 0
                           ? scaledDouble(angle, fall)
                           : (octant.offset + scaled(angle, fall) * octant.sign).value(),
                       y);
}

double exponential(double x) {
  constexpr double kHighest = 710, kLowest = -746;
  if (std::isnan(x)) return kNaN;
  if (x > kHighest) return kInfinity;
  if (x < kLowest) return 0;
  if (const auto sure = quickExponential(x)) return *sure;
  const auto [fraction, exponent] = exponentialOf(x);
  return scaledDouble(fraction, exponent);
}

double logarithm(double x) {
  if (std::isnan(x) || x < 0) return kNaN;
  if (x == 0) return -kInfinity;
  return std::isinf(x) ? x : logarithmOf(x).value();
}

double hyperbolicTangent(double x) {
  constexpr double kOne = 20;  // above it the result rounds to 1
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

}  // namespace rotatebook
