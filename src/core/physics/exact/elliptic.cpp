#include "physics/exact/elliptic.h"

#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <cmath>
#include <limits>

namespace rotatebook::physics {
namespace {

namespace policies = boost::math::policies;

// Neither long doubles, which are another number on every machine, nor exceptions.
using Policy = policies::policy<
    policies::promote_double<false>, policies::domain_error<policies::ignore_error>,
    policies::pole_error<policies::ignore_error>, policies::overflow_error<policies::ignore_error>,
    policies::underflow_error<policies::ignore_error>,
    policies::denorm_error<policies::ignore_error>,
    policies::evaluation_error<policies::ignore_error>>;

constexpr DoubleDouble kPi{3.141592653589793, 1.2246467991473532e-16};

// Under this k1 what is left out of the hyperbolic forms, m1 and its multiples, is rounding.
constexpr double kHyperbolic = 1e-9;

}  // namespace

CompleteIntegrals completeIntegrals(DoubleDouble k1, DoubleDouble n) {
  constexpr double kEnough = 1e-17;  // the error left is its square
  DoubleDouble a = 1.0, g = k1;
  DoubleDouble p = squareRoot(DoubleDouble(1.0) - n);
  DoubleDouble term = 1.0, sum = 1.0;
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
  return boost::math::ellint_rf(x, y, z, Policy());
}

double carlsonRJ(double x, double y, double z, double p) {
  return boost::math::ellint_rj(x, y, z, p, Policy());
}

JacobiFunctions::JacobiFunctions(double k1) : k1_(k1) {
  constexpr double kEnough = 1e-8;  // the error left is its square
  if (k1 < kHyperbolic) {
    limit_ =
        k1 > 0 ? completeIntegrals(k1, 0.0).k.value() : std::numeric_limits<double>::infinity();
    return;
  }
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
  return k1_ < kHyperbolic ? byPulses(u) : byLanden(u);
}

// Descending Landen transformation of cn / sn. (Bulirsch 1965, procedure sncndn)
JacobiValues JacobiFunctions::byLanden(double u) const {
  constexpr double kTiny = 1e-100;  // whose square doesn't underflow
  if (std::fabs(u) < kTiny) return {u, 1, 1};
  const double phase = limit_ * u;
  double a = std::cos(phase) / std::sin(phase);
  double c = limit_ * a;
  double dn = 1;
  for (int i = levels_ - 1; i >= 0; --i) {
    a *= c;
    c *= dn;
    dn = (geometric_[i] + a) / (arithmetic_[i] + a);
    a = c / arithmetic_[i];
  }
  const double sn = std::copysign(1 / std::sqrt(c * c + 1), u);
  return {sn, c * sn, dn};
}

// cn and dn are rows of pulses sech(u - 2 j K), of which only the nearest three aren't rounding.
JacobiValues JacobiFunctions::byPulses(double u) const {
  const auto sech = [](double decay) { return 2 * decay / (1 + decay * decay); };
  const double here = sech(std::exp(-std::fabs(u)));
  const double next = sech(std::exp(std::fabs(u) - 2 * limit_));
  return {std::tanh(u), here - next, here + next};
}

ThirdKind::ThirdKind(double k1, double n) : k1_(k1), n_(n), root_(std::sqrt(-n)) {}

double ThirdKind::at(double u, const JacobiValues& values) const {
  const auto [sn, cn, dn] = values;
  if (k1_ < kHyperbolic) return -std::atan(root_ * sn) / (root_ * (1 - n_));
  return sn * sn * sn / 3 * carlsonRJ(cn * cn, dn * dn, 1, 1 - n_ * sn * sn) - u / (1 - n_);
}

}  // namespace rotatebook::physics
