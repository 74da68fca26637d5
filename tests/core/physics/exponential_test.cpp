#include "physics/integrators/exponential.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace rotatebook::physics {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kSeriesBound = 3e-16;    // measured 1.1e-16
constexpr double kRotationBound = 5e-16;  // per radian and one; measured 1e-16

const Vector3d kAxis = Vector3d(1, -2, 2) / 3;

TEST(CosineSinc, AreTheLibrarysToRounding) {
  double worst = 0;
  for (int i = 1; i <= 1000; ++i) {
    const double x = i / 2000.0;
    const auto [cosine, sinc] = cosineSinc(x * x);
    worst = std::max({worst, std::abs(cosine - std::cos(x)), std::abs(sinc - std::sin(x) / x)});
  }
  EXPECT_LT(worst, kSeriesBound);
  EXPECT_EQ(cosineSinc(0).cosine, 1);
  EXPECT_EQ(cosineSinc(0).sinc, 1);
}

TEST(RotationBy, TurnsByTheAngleAboutTheAxis) {
  for (const double angle :
       {-30.0, -3.0, -1e-9, 0.0, 1e-300, 1e-9, 0.3, 0.99, 1.01, 2.5, 6.0, 1e3}) {
    const Quaterniond turn = rotationBy(angle * kAxis);
    const Vector3d vector = std::sin(angle / 2) * kAxis;
    const double bound = kRotationBound * (1 + std::abs(angle));
    EXPECT_NEAR(turn.w(), std::cos(angle / 2), bound) << angle;
    EXPECT_LT((turn.vec() - vector).norm(), bound) << angle;
    EXPECT_NEAR(turn.norm(), 1, bound) << angle;
  }
}

TEST(RotationBy, IsNotFiniteOfWhatIsNotFinite) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double number : {std::nan(""), infinite, -infinite}) {
    EXPECT_FALSE(rotationBy({0, number, 0}).coeffs().allFinite()) << number;
  }
}

}  // namespace
}  // namespace rotatebook::physics
