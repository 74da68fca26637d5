#include "rigid/regime.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace rotatebook::rigid {
namespace {

using Eigen::Vector3d;

// I3 (I3 - I2) = 12, I1 (I2 - I1) = 3: w1 = 2 w3 is on the separatrix, whatever w2.
const Vector3d kInertia(3, 4, 6);

// `v`, which is in the order of the moments, along the axes of kOrders[i].
constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
Vector3d ordered(const Vector3d& v, const int (&axes)[3]) {
  Vector3d result;
  for (int i = 0; i < 3; ++i) result[axes[i]] = v[i];
  return result;
}

TEST(Regime, IsTheAxisThatTheMomentumCircles) {
  for (const auto& axes : kOrders) {
    const Vector3d inertia = ordered(kInertia, axes);
    EXPECT_EQ(regimeOf(inertia, ordered({1, 0.1, 0.1}, axes)), Regime::AboutSmallest);
    EXPECT_EQ(regimeOf(inertia, ordered({0.1, 0.1, -1}, axes)), Regime::AboutLargest);
    EXPECT_EQ(regimeOf(inertia, ordered({-2, 5, 1}, axes)), Regime::Separatrix);
  }
}

TEST(Regime, IsExactBesideTheSeparatrix) {
  const double larger = std::nextafter(2.0, 3), smaller = std::nextafter(2.0, 1);
  for (const double scale : {1e-300, 1e-12, 1.0, 1e12, 1e300}) {
    const double two = 2 * scale;
    EXPECT_EQ(regimeOf(kInertia, {two, 0.5, scale}), Regime::Separatrix);
    EXPECT_EQ(regimeOf(kInertia, {std::nextafter(two, 0), 0.5, scale}), Regime::AboutLargest);
    EXPECT_EQ(regimeOf(kInertia, {std::nextafter(two, 2 * two), 0.5, scale}),
              Regime::AboutSmallest);
  }
  for (const double scale : {1e-12, 1e12}) {
    EXPECT_EQ(regimeOf(std::ldexp(1, std::ilogb(scale)) * kInertia, {larger, 3, 1}),
              Regime::AboutSmallest);
    EXPECT_EQ(regimeOf(std::ldexp(1, std::ilogb(scale)) * kInertia, {smaller, 3, 1}),
              Regime::AboutLargest);
  }
}

// 3 w3^2 - w1^2 of the moments 1, 2, 3 can't be 0 in doubles, but as near to it as 1e-32: in plain
// doubles, and from L^2 - 2 T I2, the sign is a matter of luck.
TEST(Regime, IsExactWhereDoublesAreNot) {
  int differ = 0;
  for (int i = 1; i <= 200; ++i) {
    const double w3 = 1 + i / 1024.0;
    const double w1 = std::sqrt(3.0) * w3;
    // The sign of 3 w3^2 - w1^2, with w1^2 exact and 3 w3^2 of few bits.
    const DoubleDouble square = exactProduct(w1, w1);
    const double n2 = (3 * w3 * w3 - square.high) - square.low;
    const Regime expected = n2 > 0 ? Regime::AboutLargest : Regime::AboutSmallest;
    EXPECT_EQ(regimeOf({1, 2, 3}, {w1, 0.3, w3}), expected);
    const double momentum2 = w1 * w1 + 4 * 0.3 * 0.3 + 9 * w3 * w3;
    const double twiceEnergy = w1 * w1 + 2 * 0.3 * 0.3 + 3 * w3 * w3;
    const double naive = momentum2 - 2 * twiceEnergy;
    differ += (naive > 0) != (n2 > 0);
  }
  EXPECT_GT(differ, 20);
}

TEST(Regime, SeesTheSmallestSpin) {
  EXPECT_EQ(regimeOf(kInertia, {0, 1, 1e-300}), Regime::AboutLargest);
  EXPECT_EQ(regimeOf(kInertia, {1e-300, 1, 0}), Regime::AboutSmallest);
  EXPECT_EQ(regimeOf({3, 4, std::nextafter(4.0, 5)}, {0, 1, 1e-322}), Regime::AboutLargest);
  EXPECT_EQ(regimeOf(kInertia, {1e-160, 1, 1e-300}), Regime::AboutSmallest);
  EXPECT_EQ(regimeOf(kInertia, {1e-300, 1e-300, 1}), Regime::AboutLargest);
  EXPECT_EQ(regimeOf(kInertia, {2e-300, 1, 1e-300}), Regime::Separatrix);
}

TEST(Regime, OfSymmetricTopsAndSpheres) {
  EXPECT_EQ(regimeOf({1, 1, 2}, {3, 4, 1e-200}), Regime::AboutLargest);
  EXPECT_EQ(regimeOf({1, 1, 2}, {3, 4, 0}), Regime::Separatrix);
  EXPECT_EQ(regimeOf({2, 1, 2}, {3, 1e-200, 4}), Regime::AboutSmallest);
  EXPECT_EQ(regimeOf({2, 2, 2}, {3, 1, 4}), Regime::Separatrix);
  EXPECT_EQ(regimeOf(kInertia, {0, 0, 0}), Regime::Separatrix);
  EXPECT_EQ(regimeOf(kInertia, {0, -1, 0}), Regime::Separatrix);
}

TEST(MedianInvariantRoot, HasTheSignAndSizeOfTheInvariant) {
  EXPECT_EQ(middleInvariantRoot({3, 4, 6}, 0, 1).value(), std::sqrt(12));
  EXPECT_EQ(middleInvariantRoot({3, 4, 6}, 1, 0).value(), -std::sqrt(3));
  EXPECT_DOUBLE_EQ(middleInvariantRoot({3e12, 4e12, 6e12}, 0, 1e-300).value(),
                   1e-288 * std::sqrt(12));
  // 12 - 3 (2 - d)^2 = 12 d - 3 d^2 for one unit in the last place d.
  const double unit = std::numeric_limits<double>::epsilon();
  EXPECT_DOUBLE_EQ(middleInvariantRoot({3, 4, 6}, 2 - unit, 1).value(),
                   std::sqrt(12 * unit - 3 * unit * unit));
}

}  // namespace
}  // namespace rotatebook::rigid
