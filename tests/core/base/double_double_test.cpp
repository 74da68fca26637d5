#include "base/double_double.h"

#include <cmath>

#include <gtest/gtest.h>

namespace rotatebook {
namespace {

constexpr double kBound = 1e-31;  // relative; measured 9e-33

double relativeError(DoubleDouble value, DoubleDouble expected) {
  return std::fabs(((value - expected) / expected).value());
}

const DoubleDouble kThird{1.0 / 3, 1.850371707708594e-17};
const DoubleDouble kRootOfTwo{1.4142135623730951, -9.667293313452913e-17};

TEST(DoubleDouble, LosesNothingInASumOrProductOfTwo) {
  EXPECT_EQ(exactSum(1e20, 1).low, 1);
  const double a = 1 + std::ldexp(1, -40);
  EXPECT_EQ(exactProduct(a, a).low, std::ldexp(1, -80));
  EXPECT_EQ(exactProduct(a, a).high, 1 + std::ldexp(1, -39));
}

TEST(DoubleDouble, ReckonsToThirtyDigits) {
  EXPECT_LT(relativeError(DoubleDouble(1.0) / 3.0, kThird), kBound);
  EXPECT_LT(relativeError(kThird * 3.0, 1.0), kBound);
  EXPECT_LT(relativeError(kThird + kThird + kThird, 1.0), kBound);
  EXPECT_LT(relativeError(squareRoot(2.0), kRootOfTwo), kBound);
  EXPECT_LT(relativeError(kRootOfTwo * kRootOfTwo, 2.0), kBound);
  // A double alone wouldn't.
  EXPECT_GT(relativeError(kRootOfTwo.high * kRootOfTwo, 2.0), 1e-18);
}

TEST(DoubleDouble, FindsTheHypotenuseOfTheSmallest) {
  const DoubleDouble small = hypotenuse(3e-200, 4e-200);
  EXPECT_NEAR(small.value() / 5e-200, 1, 1e-15);
  EXPECT_EQ(hypotenuse(0.0, 0.0).value(), 0);
  EXPECT_EQ(hypotenuse(1e-300, 1.0).value(), 1);
}

}  // namespace
}  // namespace rotatebook
