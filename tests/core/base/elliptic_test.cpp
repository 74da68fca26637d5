#include "base/elliptic.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

constexpr double kFunctionBound = 5e-15;  // measured 1.6e-15
constexpr double kRelativeBound = 1e-14;  // of cn and dn; measured 1.8e-15
constexpr double kIntegralBound = 2e-15;  // relative; measured 6e-16
constexpr double kIdentityBound = 2e-15;  // measured 7e-16

struct JacobiCase {
  double u, m1, sn, cn, dn;
};

// Computed at 60 digits from the doubles u and m1.
constexpr JacobiCase kJacobiCases[] = {
    {0.3, 1.0, 0.29552020666133956, 0.95533648912560602, 1.0},
    {0.3, 0.75, 0.29446555154955623, 0.95566209454525068, 0.98910187025283392},
    {1.7, 0.5, 0.99404770074086053, 0.10894571424250056, 0.71129078746030747},
    {-2.9, 0.1, -0.99466078320636952, -0.10319848037297626, 0.33103615167555705},
    {1.0, 0.001, 0.76167955608840942, 0.6479538979255882, 0.64840142626549381},
    {4.5, 0.001, 0.99993952491587368, 0.010997568413828845, 0.033478733018228588},
    {-3.0, 1e-08, -0.99505475610037176, 0.099327903239873508, 0.09932795308154372},
    {10.0, 1e-08, 0.99999999799865727, 6.3266780038810216e-5, 0.00011833294307356823},
    {8.0, 1e-16, 0.99999977492967591, 0.00067092518026507946, 0.00067092518033960339},
    {19.5, 1e-16, 1.0, 3.1181910634712874e-9, 1.0474880214509004e-8},
    {2.0, 1e-30, 0.96402758007581688, 0.26580222883407969, 0.26580222883407969},
    {35.0, 1e-30, 1.0, 1.062771670490219e-15, 1.4592750335685767e-15},
    {-1.2, 0.0, -0.83365460701215525, 0.55228615427820477, 0.55228615427820477},
    {20.0, 0.0, 1.0, 4.1223072448771156e-9, 4.1223072448771156e-9},
    {100.25, 0.3, 0.56923496242119428, 0.82217489475010214, 0.87930659629627428},
};

double completeK(double m1) {
  return completeIntegrals(squareRoot(m1), 0.0).k.value();
}

// At any u, brought to within K of a zero of sn.
JacobiValues jacobi(double u, double m1) {
  if (m1 == 0) return JacobiFunctions(0).at(u);
  const DoubleDouble k = completeIntegrals(squareRoot(m1), 0.0).k;
  const double halves = std::nearbyint(u / (2 * k.high));
  const double r = (DoubleDouble(u) - k * (2 * halves)).value();
  const JacobiValues values = JacobiFunctions(std::sqrt(m1)).at(r);
  const double sign = std::fmod(halves, 2) == 0 ? 1 : -1;
  return {sign * values.sn, sign * values.cn, values.dn};
}

double relativeError(double value, double expected) {
  return std::fabs(value / expected - 1);
}

TEST(Jacobi, AgreesWithSixtyDigits) {
  for (const JacobiCase& c : kJacobiCases) {
    SCOPED_TRACE(testing::Message() << "u " << c.u << ", m1 " << c.m1);
    const JacobiValues values = jacobi(c.u, c.m1);
    EXPECT_NEAR(values.sn, c.sn, kFunctionBound);
    EXPECT_NEAR(values.cn, c.cn, kFunctionBound);
    EXPECT_NEAR(values.dn, c.dn, kFunctionBound);
    EXPECT_LT(relativeError(values.cn, c.cn), kRelativeBound);
    EXPECT_LT(relativeError(values.dn, c.dn), kRelativeBound);
  }
}

TEST(Jacobi, IsPeriodic) {
  const double k = completeK(0.25);
  for (const double u : {-0.8 * k, 0.1 * k, 0.7 * k}) {
    for (const int halves : {-3, -2, 1, 2}) {
      const double sign = halves % 2 == 0 ? 1 : -1;
      const JacobiValues here = jacobi(u, 0.25), there = jacobi(u + 2 * halves * k, 0.25);
      EXPECT_NEAR(there.sn, sign * here.sn, kFunctionBound);
      EXPECT_NEAR(there.cn, sign * here.cn, kFunctionBound);
      EXPECT_NEAR(there.dn, here.dn, kFunctionBound);
    }
  }
}

TEST(JacobiFunctions, KeepTheirIdentities) {
  for (double k1 = 1; k1 > 1e-12; k1 /= 1.7) {
    const JacobiFunctions functions(k1);
    const double k = completeIntegrals(k1, 0.0).k.value();
    for (int i = -20; i <= 20; ++i) {
      const auto [sn, cn, dn] = functions.at(k * i / 20);
      EXPECT_NEAR(sn * sn + cn * cn, 1, kIdentityBound) << k1;
      EXPECT_NEAR(dn * dn, cn * cn + k1 * k1 * sn * sn, kIdentityBound * dn) << k1;
    }
  }
}

TEST(JacobiFunctions, MeetWhereTheHyperbolicFormBegins) {
  const JacobiFunctions below(0.999999999999e-9), above(1e-9);
  for (double u = -20; u <= 20; u += 0.37) {
    EXPECT_NEAR(below.at(u).sn, above.at(u).sn, kFunctionBound);
    EXPECT_NEAR(below.at(u).cn, above.at(u).cn, kFunctionBound);
    EXPECT_NEAR(below.at(u).dn, above.at(u).dn, kFunctionBound);
  }
}

TEST(JacobiFunctions, HoldForTheSmallestArguments) {
  for (const double k1 : {1.0, 0.5, 1e-6, 1e-12, 0.0}) {
    for (const double u : {0.0, 1e-300, -1e-160, 1e-99, 1e-20}) {
      const auto [sn, cn, dn] = JacobiFunctions(k1).at(u);
      EXPECT_NEAR(sn, u, kFunctionBound * std::fabs(u)) << k1;
      EXPECT_NEAR(cn, 1, kFunctionBound);
      EXPECT_NEAR(dn, 1, kFunctionBound);
    }
  }
}

TEST(CompleteK, AgreesDownToTheSmallestParameter) {
  // {m1, K at 700 digits}
  constexpr double kCases[][2] = {{1.0, 1.5707963267948966},    {0.9, 1.6124413487202194},
                                  {0.5, 1.8540746773013719},    {0.001, 4.841132560550297},
                                  {1e-12, 15.201804919087715},  {1e-30, 35.925070756030576},
                                  {1e-100, 116.51554901082217}, {1e-300, 346.77405831022674}};
  for (const auto& [m1, k] : kCases) EXPECT_LT(relativeError(completeK(m1), k), kIntegralBound);
#ifdef __cpp_lib_math_special_functions
  // The modulus in place of the parameter loses what m1 holds.
  EXPECT_GT(relativeError(std::comp_ellint_1(std::sqrt(1 - 1e-12)), 15.201804919087715), 1e-7);
#endif
}

TEST(CompleteK, HoldsTwiceTheDigits) {
  const DoubleDouble k = completeIntegrals(1.0, 0.0).k;
  EXPECT_EQ(k.high, std::numbers::pi / 2);
  EXPECT_NEAR(k.low, 6.123233995736766e-17, 1e-31);  // half of pi's second double
}

TEST(Carlson, AgreesWithThePublishedValues) {
  constexpr double kPublished = 1e-13;  // of 14 digits (Carlson 1995)
  EXPECT_NEAR(carlsonRF(1, 2, 0), 1.3110287771461, kPublished);
  EXPECT_NEAR(carlsonRF(0.5, 1, 0), 1.8540746773014, kPublished);
  EXPECT_NEAR(carlsonRF(2, 3, 4), 0.58408284167715, kPublished);
  EXPECT_NEAR(carlsonRJ(0, 1, 2, 3), 0.77688623778582, kPublished);
  EXPECT_NEAR(carlsonRJ(2, 3, 4, 5), 0.14297579667157, kPublished);
}

TEST(EllipticPi, AgreesWithQuadrature) {
  // {u, k1, n, integral at 40 digits}
  constexpr double kCases[][4] = {
      {0.5, 1.0, 0.0, 0.039632253798025873},   {1.2, 0.8, -0.3, 0.35217303445626225},
      {-1.5, 0.8, -1.0, -0.41155912992906964}, {2.5, 0.1, -0.25, 1.2702922016097828},
      {3.6, 0.1, -1e-06, 2.6110741980851556},  {12.0, 1e-05, -0.5, 7.4197201660241144},
      {3.0, 1e-10, -0.5, 1.4219216780177535},  {20.0, 1e-10, -1.0, 9.6073009183012758},
      {7.0, 0.0, -0.1, 5.4831522086627095}};
  for (const auto& [u, k1, n, integral] : kCases) {
    const double value = EllipticPi(k1, n).at(u, JacobiFunctions(k1).at(u)) + u / (1 - n);
    EXPECT_LT(relativeError(value, integral), kIntegralBound) << u << ' ' << k1 << ' ' << n;
  }
}

TEST(EllipticPi, EndsInTheCompleteIntegral) {
  for (const double k1 : {1.0, 0.7, 0.1, 1e-3, 1e-8, 1e-11}) {
    for (const double n : {-1.0, -0.4, -1e-5}) {
      const CompleteIntegrals complete = completeIntegrals(k1, n);
      const double k = complete.k.value();
      const double incomplete = EllipticPi(k1, n).at(k, JacobiFunctions(k1).at(k)) + k / (1 - n);
      EXPECT_LT(relativeError(incomplete, complete.j.value()), kIntegralBound) << k1 << ' ' << n;
    }
  }
}

}  // namespace
}  // namespace rotatebook
