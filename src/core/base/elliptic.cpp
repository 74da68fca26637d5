#include "base/elliptic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"

namespace rotatebook {
namespace {

// Below this k1, what the hyperbolic forms leave out, m1 and its multiples, is rounding.
constexpr double kHyperbolic = 1e-9;

// Returns Carlson's RC(1, 1 + e), which is atan(sqrt(e)) / sqrt(e), by duplication.
double carlsonRC(double e) {
  constexpr double kEnough = 160;  // mean / distance, at which the series has an error of 2^-53
  double x = 1, y = 1 + e, mean = 1 + e * (2.0 / 3), distance = e / 3;

  // Duplicate the arguments until they are nearly equal
  while (kEnough * std::fabs(distance) > mean) {
    const double lambda = 2 * std::sqrt(x * y) + y;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    mean = (mean + lambda) / 4;
    distance /= 4;
  }

  // Sum the series about their mean
  const double s = distance / mean;
  const double inner = 3.0 / 8 + s * (9.0 / 22 + s * (159.0 / 208 + s * (9.0 / 8)));
  return (1 + s * s * (0.3 + s * (1.0 / 7 + s * inner))) / std::sqrt(mean);
}

}  // namespace

CompleteIntegrals completeIntegrals(DoubleDouble k1, DoubleDouble n) {
  constexpr double kEnough = 1e-17;  // the error left is its square
  DoubleDouble a = 1.0, g = k1;
  DoubleDouble p = squareRoot(DoubleDouble(1.0) - n);
  DoubleDouble term = 1.0, sum = 1.0;
  // Take the mean of a and g, and with it the sum of the third kind's terms
  for (int i = 0; i < 40; ++i) {
    const bool last = std::fabs((a - g).high) <= kEnough && std::fabs(term.high) <= kEnough;
    const DoubleDouble ag = a * g, pp = p * p;
    term = term * (pp - ag) / (pp + ag) * 0.5;
    sum = sum + term;
    p = (pp + ag) / (p * 2.0);
    a = (a + g) * 0.5;
    g = squareRoot(ag);
    if (last) break;
  }
  const DoubleDouble k = kPi / (a * 2.0);
  return {k, k * 0.5 * sum / (DoubleDouble(1.0) - n)};
}

double carlsonRF(double x, double y, double z) {
  constexpr double kEnough = 400;  // mean / distance, at which the series has an error of 2^-53
  const double start = (x + y + z) / 3;
  double dx = start - x, dy = start - y;
  double distance = kEnough * std::max({std::fabs(dx), std::fabs(dy), std::fabs(start - z)});
  double mean = start;

  // Duplicate the arguments until they are nearly equal
  while (distance > mean) {
    const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
    const double lambda = rx * ry + (rx * rz + ry * rz);
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    mean = (mean + lambda) / 4;
    distance /= 4;
    dx /= 4;
    dy /= 4;
  }

  // Sum the series in the elementary symmetric functions of the deviations from their mean
  dx /= mean;
  dy /= mean;
  const double dz = -(dx + dy), e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
  return (1 - e2 / 10 + e3 / 14 + e2 * (e2 / 24 - e3 * (3.0 / 44))) / std::sqrt(mean);
}

double carlsonRJ(double x, double y, double z, double p) {
  constexpr double kEnough = 520;  // mean / distance, at which the series has an error of 2^-53
  const double start = (x + y + z + 2 * p) / 5;
  double dx = start - x, dy = start - y, dz = start - z;
  double distance =
      kEnough * std::max({std::fabs(dx), std::fabs(dy), std::fabs(dz), std::fabs(start - p)});
  double delta = (p - x) * (p - y) * (p - z);
  double mean = start, share = 1, sum = 0;

  // Duplicate the arguments until they are nearly equal, adding an RC each time
  while (distance > mean) {
    const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z), rp = std::sqrt(p);
    const double d = (rp + rx) * (rp + ry) * (rp + rz);
    sum += share / d * carlsonRC(delta / (d * d));
    const double lambda = rx * ry + (rx * rz + ry * rz);
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    p = (p + lambda) / 4;
    mean = (mean + lambda) / 4;
    distance /= 4;
    delta /= 64;
    share /= 4;
  }

  // Sum the series in the elementary symmetric functions of the deviations from their mean
  dx *= share / mean;
  dy *= share / mean;
  dz *= share / mean;
  const double dp = -(dx + dy + dz) / 2;
  const double xyz = dx * dy * dz, pp = dp * dp;
  const double e2 = dx * dy + dx * dz + dy * dz - 3 * pp;
  const double e3 = xyz + 2 * dp * (e2 + 2 * pp);
  const double e4 = dp * (2 * xyz + dp * (e2 + 3 * pp));
  const double e5 = xyz * pp;
  const double series = 1 - e2 * (3.0 / 14 - e2 * (9.0 / 88) + e3 * (9.0 / 52)) + e3 / 6 -
                        e4 * (3.0 / 22) + e5 * (3.0 / 26);
  return share * series / (mean * std::sqrt(mean)) + 6 * sum;
}

JacobiFunctions::JacobiFunctions(double k1) : k1_(k1) {
  constexpr double kEnough = 1e-8;  // the error left is its square
  // Near the separatrix the hyperbolic forms need K alone
  if (k1 < kHyperbolic) {
    limit_ =
        k1 > 0 ? completeIntegrals(k1, 0.0).k.value() : std::numeric_limits<double>::infinity();
    limitDecay_ = exponential(-limit_);
    return;
  }

  // Keep the levels of the arithmetic-geometric mean of 1 and k1
  double a = 1, g = k1;
  while (levels_ < kMaxLevels) {
    arithmetic_[levels_] = a;
    geometric_[levels_] = g;
    ++levels_;
    limit_ = (a + g) / 2;
    if (std::fabs(a - g) <= kEnough * a) break;
    g = std::sqrt(a * g);
    a = limit_;
  }
}

JacobiValues JacobiFunctions::at(double u) const {
  return k1_ < kHyperbolic ? byHyperbolicSeries(u) : byLanden(u);
}

// Uses Landen's descending transformation of cn / sn. (Bulirsch 1965, procedure sncndn)
JacobiValues JacobiFunctions::byLanden(double u) const {
  constexpr double kSmallest = 1e-100;  // whose square doesn't underflow
  if (std::fabs(u) < kSmallest) return {u, 1, 1};

  // Start from the circular functions at the limit of the means
  const auto [cosine, sine] = cosineSine(limit_ * u);
  double a = cosine / sine;
  double c = limit_ * a;
  double dn = 1;

  // Climb back to the given parameter, level by level
  for (int i = levels_ - 1; i >= 0; --i) {
    a *= c;
    c *= dn;
    dn = (geometric_[i] + a) / (arithmetic_[i] + a);
    a = c / arithmetic_[i];
  }
  const double sn = std::copysign(1 / std::sqrt(c * c + 1), u);
  return {sn, c * sn, dn};
}

// Sums the rows of pulses sech(u - 2 j K) that cn and dn are; only the nearest two exceed rounding.
JacobiValues JacobiFunctions::byHyperbolicSeries(double u) const {
  constexpr double kNear = 0.5;  // where 1 - e^-2u would cancel
  const auto sech = [](double decay) { return 2 * decay / (1 + decay * decay); };
  const double decay = exponential(-std::fabs(u));
  const double fromNext = limitDecay_ > 0 ? limitDecay_ * (limitDecay_ / decay) : 0;
  const double here = sech(decay), next = sech(fromNext);
  const double sn = std::fabs(u) < kNear
                        ? hyperbolicTangent(u)
                        : std::copysign((1 - decay * decay) / (1 + decay * decay), u);
  return {sn, here - next, here + next};
}

EllipticPi::EllipticPi(double k1, double n) : k1_(k1), n_(n), root_(std::sqrt(-n)) {}

double EllipticPi::at(double u, const JacobiValues& values) const {
  const auto [sn, cn, dn] = values;
  if (k1_ < kHyperbolic) return -arcTangent(root_ * sn) / (root_ * (1 - n_));
  return sn * sn * sn / 3 * carlsonRJ(cn * cn, dn * dn, 1, 1 - n_ * sn * sn) - u / (1 - n_);
}

}  // namespace rotatebook
