// Elliptic functions and integrals in the complementary parameter m1 = 1 - m, which loses no digits
// near m = 1.
#pragma once

#include <array>

#include "base/double_double.h"

namespace rotatebook {

/// Jacobi's sn, cn and dn of one argument.
struct JacobiValues {
  double sn = 0;
  double cn = 1;
  double dn = 1;
};

/// Complete elliptic integrals of one parameter.
struct CompleteIntegrals {
  DoubleDouble k;  ///< K, a quarter of the period of sn.
  /// Integral of sn^2 / (1 - n sn^2) from 0 to K, which is (Pi(n) - K) / n.
  DoubleDouble j;
};

/// Returns both, by the arithmetic-geometric mean to 30 digits; k1 = sqrt(m1) in (0, 1], n <= 0.
/// (DLMF 19.8.6 to 19.8.9)
CompleteIntegrals completeIntegrals(DoubleDouble k1, DoubleDouble n);

/// Returns Carlson's RF(x, y, z) of numbers >= 0, at most one of them 0. (Carlson 1995)
double carlsonRF(double x, double y, double z);
/// Returns Carlson's RJ(x, y, z, p); x, y, z >= 0, at most one of them 0; p > 0. (Carlson 1995)
double carlsonRJ(double x, double y, double z, double p);

/// Computes sn, cn and dn of one parameter, whose constants are computed once. Accurate to a few
/// 1e-16 of the result, except that the rounding of u affects cn and dn near their zeros.
class JacobiFunctions {
 public:
  /// Takes k1 = sqrt(m1) in [0, 1] and not m1, because m1 underflows where k1 doesn't.
  explicit JacobiFunctions(double k1);

  /// Returns the functions at u in [-K, K]; at any u if k1 = 0.
  JacobiValues at(double u) const;

 private:
  static constexpr int kMaxLevels = 12;

  JacobiValues byLanden(double u) const;
  JacobiValues byHyperbolicSeries(double u) const;

  double k1_;
  int levels_ = 0;
  std::array<double, kMaxLevels> arithmetic_{};  // the means of each level
  std::array<double, kMaxLevels> geometric_{};
  double limit_ = 1;       // of both means; near the separatrix K itself
  double limitDecay_ = 0;  // e^-K, near the separatrix
};

/// Computes P(u) = J(u) - u / (1 - n), where J is the integral of sn^2 / (1 - n sn^2) from 0, for u
/// in [-K, K], or any u if k1 = 0. The subtracted term is the growth of J near the separatrix,
/// where u may be large: there the rest is bounded.
class EllipticPi {
 public:
  /// Takes k1 = sqrt(1 - m) in [0, 1] and n in [-1, 0].
  EllipticPi(double k1, double n);

  /// Returns P(u); `values` are the Jacobi functions at `u`.
  double at(double u, const JacobiValues& values) const;

 private:
  double k1_;
  double n_;
  double root_;  // sqrt(-n)
};

}  // namespace rotatebook
