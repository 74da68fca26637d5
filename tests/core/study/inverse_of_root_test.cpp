// Reciprocal roots from products and sums, which lanes take for a root and a division.
#include "study/lanes/inverse_of_root.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "physics/steps/number.h"

namespace rotatebook::study::lanes {
namespace {

// A number like those of processors with fused products and sums.
struct Fused {
  double value;

  explicit Fused(double number) : value(number) {}

  friend Fused operator+(Fused a, Fused b) { return Fused(a.value + b.value); }
  friend Fused operator-(Fused a, Fused b) { return Fused(a.value - b.value); }
  friend Fused operator*(Fused a, Fused b) { return Fused(a.value * b.value); }
  friend Fused fusedSum(Fused a, Fused b, Fused c) {
    return Fused(std::fma(a.value, b.value, c.value));
  }
  friend Fused fusedRest(Fused a, Fused b, Fused c) {
    return Fused(std::fma(-a.value, b.value, c.value));
  }
};

double seriesOf(double x) {
  const double e = x - 1;
  return (1 - e / 2) + e * e * (0.375 - 0.3125 * e);
}

bool isRight(double x, double series) {
  return inverseOfRoot(Fused(x), Fused(series)).value == 1 / std::sqrt(x);
}

// All numbers of the range whose root, or its reciprocal, is within 2^-101 of the middle between
// two doubles, relative to it, where an error might change the rounding: the roots of
// m^2 = k modulo 2^54 or 2^55, and the divisors of 2^106 + k, for all small k. Nearer to 1 the
// series is the result.
constexpr std::array kHard{
    0x1.f149abbda490ap-1, 0x1.f149abbda490bp-1, 0x1.f306808b31fdbp-1, 0x1.f306808b31fdcp-1,
    0x1.f397129a5c764p-1, 0x1.f397129a5c765p-1, 0x1.f41407fcf3f04p-1, 0x1.f41407fcf3f05p-1,
    0x1.f415d8cc952efp-1, 0x1.f415d8cc952f0p-1, 0x1.f4bbe77b21e99p-1, 0x1.f4bbe77b21e9ap-1,
    0x1.f5ca574032c74p-1, 0x1.f5ca574032c75p-1, 0x1.f6a3429010439p-1, 0x1.f6a342901043ap-1,
    0x1.f7f7151534da0p-1, 0x1.f7f7151534da1p-1, 0x1.f974b2f9b9fd3p-1, 0x1.f9d926ff83b0dp-1,
    0x1.f9d926ff83b0ep-1, 0x1.fc4b3920bb528p-1, 0x1.fc4b3920bb529p-1, 0x1.fd39256967f91p-1,
    0x1.fd39256967f92p-1, 0x1.fe0c675d4cc76p-1, 0x1.fe0c675d4cc77p-1, 0x1.ff375d8afeaa5p-1,
    0x1.ff375d8afeaa6p-1, 0x1.ff715b5d1613cp-1, 0x1.ff715b5d1613dp-1, 0x1.022d799316102p0,
    0x1.022d799316103p0,  0x1.029af6f54e897p0,  0x1.029af6f54e898p0,  0x1.0499b629293aap0,
    0x1.0499b629293abp0,  0x1.04d12ca145850p0,  0x1.05a7df7a93bc0p0,  0x1.069b76ca13a5bp0};

TEST(InverseOfRoot, IsRightWhereRoundingIsHardest) {
  for (const double x : kHard) EXPECT_TRUE(isRight(x, seriesOf(x))) << std::hexfloat << x;
}

TEST(InverseOfRoot, IsRightInItsWholeRange) {
  constexpr int kSteps = 2'000'000;
  int wrong = 0, wrongFromLess = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double x = 1 + physics::kRootReach * i / kSteps;
    wrong += isRight(x, seriesOf(x)) ? 0 : 1;
    wrongFromLess += isRight(x, 1 - (x - 1) / 2) ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(wrongFromLess, 1'000'000);  // measured 2163391
}

}  // namespace
}  // namespace rotatebook::study::lanes
