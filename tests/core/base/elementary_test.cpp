#include "base/elementary.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/correct_rounding.h"

namespace rotatebook {
namespace {

using Limits = std::numeric_limits<double>;

constexpr double kInfinity = Limits::infinity();
constexpr double kNaN = Limits::quiet_NaN();
constexpr double kSmallest = Limits::denorm_min();
constexpr double kLargest = Limits::max();
constexpr int kArguments = 10'000;

// So that zeros of different signs differ.
std::uint64_t bitsOf(double number) {
  return std::bit_cast<std::uint64_t>(number);
}

class Elementary : public testing::TestWithParam<RoundedFunction> {};

// bench/elementary_accuracy.cpp does the same with ten million.
TEST_P(Elementary, IsRoundedCorrectly) {
  for (const auto& [x, y] : wronglyRounded(GetParam(), kArguments)) {
    ADD_FAILURE() << std::hexfloat << GetParam().name << " of " << x << " " << y;
  }
}

INSTANTIATE_TEST_SUITE_P(Function, Elementary, testing::ValuesIn(roundedFunctions()),
                         [](const auto& instance) {
                           std::string name = instance.param.name;
                           std::erase(name, ' ');
                           return name;
                         });

// One last place, of a few arguments.
TEST(WronglyRounded, FindsWhatIsWrong) {
  RoundedFunction function = roundedFunctions().front();
  const auto own = function.own;
  function.own = [&own](RoundedFunction::Point at) {
    const double value = own(at);
    return at.x > 7.99 && at.x < 8 ? std::nextafter(value, 2) : value;
  };
  EXPECT_FALSE(wronglyRounded(function, kArguments).empty());
}

TEST(Reference, RoundsOnceWhereTheBitsEndHalfWay) {
  Reference reference;
  // A hair under one and a half of the smallest number.
  EXPECT_EQ(reference.of(mpfr_atan2, 3 * kSmallest, 2.0), kSmallest);
  EXPECT_EQ(arcTangent(3 * kSmallest, 2), kSmallest);
  // 3 : 4 : 5 in parts of which a double has one too few.
  const double part = 0x1.2d5c1p24;
  EXPECT_EQ(reference.of(mpfr_hypot, 3 * part, 4 * part), 5 * part);
}

TEST(Elementary, KeepsTheSignOfZero) {
  for (const double zero : {0.0, -0.0}) {
    EXPECT_EQ(bitsOf(sine(zero)), bitsOf(zero));
    EXPECT_EQ(bitsOf(arcTangent(zero)), bitsOf(zero));
    EXPECT_EQ(bitsOf(hyperbolicTangent(zero)), bitsOf(zero));
    EXPECT_EQ(bitsOf(inverseHyperbolicSine(zero)), bitsOf(zero));
    EXPECT_EQ(cosine(zero), 1);
    EXPECT_EQ(exponential(zero), 1);
    EXPECT_EQ(logarithm(zero), -kInfinity);
  }
  EXPECT_EQ(bitsOf(logarithm(1)), bitsOf(0.0));
  EXPECT_EQ(bitsOf(roundedHypotenuse(-0.0, -0.0)), bitsOf(0.0));
}

TEST(Elementary, HoldsAtBothEndsOfTheNumbers) {
  for (const double size : {kSmallest, 3 * kSmallest, Limits::min(), 1e-300}) {
    for (const double x : {size, -size}) {
      EXPECT_EQ(sine(x), x);
      EXPECT_EQ(arcTangent(x), x);
      EXPECT_EQ(hyperbolicTangent(x), x);
      EXPECT_EQ(inverseHyperbolicSine(x), x);
      EXPECT_EQ(cosine(x), 1);
      EXPECT_EQ(exponential(x), 1);
      EXPECT_EQ(roundedHypotenuse(x, 0), size);
    }
  }
  EXPECT_EQ(logarithm(kSmallest), -744.4400719213812);
  EXPECT_EQ(logarithm(kLargest), 709.782712893384);
  EXPECT_EQ(inverseHyperbolicSine(kLargest), 710.475860073944);
  EXPECT_EQ(hyperbolicTangent(-kLargest), -1);
  EXPECT_EQ(exponential(709.782712893384), 0x1.fffffffffff2ap1023);
  EXPECT_EQ(exponential(std::nextafter(709.782712893384, 710)), kInfinity);
  EXPECT_EQ(exponential(-745.1332191019411), kSmallest);
  EXPECT_EQ(exponential(-745.1332191019412), 0);
  EXPECT_EQ(roundedHypotenuse(kLargest, kLargest), kInfinity);
  EXPECT_EQ(roundedHypotenuse(kLargest, 1e290), kLargest);
}

TEST(Elementary, HasTheLimitsOfTheInfinite) {
  EXPECT_EQ(arcTangent(-kInfinity), -kPi.high / 2);
  EXPECT_EQ(exponential(kInfinity), kInfinity);
  EXPECT_EQ(exponential(-kInfinity), 0);
  EXPECT_EQ(logarithm(kInfinity), kInfinity);
  EXPECT_EQ(hyperbolicTangent(-kInfinity), -1);
  EXPECT_EQ(inverseHyperbolicSine(-kInfinity), -kInfinity);
  EXPECT_EQ(roundedHypotenuse(kNaN, -kInfinity), kInfinity);
  EXPECT_EQ(roundedHypotenuse(-kInfinity, 1), kInfinity);
}

// As C has it of atan2.
TEST(ArcTangent, HasADirectionForEveryPoint) {
  const double specials[] = {0.0, -0.0, 1, -1, kInfinity, -kInfinity, kSmallest, -kLargest};
  for (const double y : specials) {
    for (const double x : specials) {
      EXPECT_EQ(bitsOf(arcTangent(y, x)), bitsOf(std::atan2(y, x))) << y << " " << x;
    }
  }
}

TEST(Elementary, GivesNoNumberWhereThereIsNone) {
  for (const double x : {kNaN, kInfinity, -kInfinity, std::nextafter(kLargestAngle, 2e6), -1e300}) {
    EXPECT_TRUE(std::isnan(sine(x))) << x;
    EXPECT_TRUE(std::isnan(cosine(x))) << x;
    EXPECT_TRUE(std::isnan(cosineSine(x).sine)) << x;
  }
  EXPECT_FALSE(std::isnan(sine(-kLargestAngle)));
  for (double (*function)(double) :
       {exponential, logarithm, hyperbolicTangent, inverseHyperbolicSine}) {
    EXPECT_TRUE(std::isnan(function(kNaN)));
  }
  EXPECT_TRUE(std::isnan(arcTangent(kNaN)));
  EXPECT_TRUE(std::isnan(arcTangent(kNaN, 0)));
  EXPECT_TRUE(std::isnan(arcTangent(kInfinity, kNaN)));
  EXPECT_TRUE(std::isnan(logarithm(-kSmallest)));
  EXPECT_TRUE(std::isnan(roundedHypotenuse(1, kNaN)));
}

// An angle's second double counts: the cosine of pi/2 is what the first lacks.
TEST(CosineSine, TakesAnAngleOfTwoDoubles) {
  EXPECT_EQ(cosineSine(kPi.high / 2).cosine, 6.123233995736766e-17);
  EXPECT_LT(std::fabs(cosineSine(kPi * 0.5).cosine), 1e-32);  // measured 1.5e-33
}

}  // namespace
}  // namespace rotatebook
