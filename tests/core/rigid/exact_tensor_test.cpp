// The exact motion of bodies whose tensor isn't diagonal.
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "rigid/exact_rotation.h"
#include "rigid/inertia.h"

namespace rotatebook::rigid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kTurnedBound = 1e-12;      // measured 6e-16
constexpr double kSixtyDigitBound = 1e-13;  // measured 1.6e-15
constexpr double kPairBound = 1e-29;        // relative to the largest; measured 5e-33

// Three times a rotation: whole numbers, so that no tensor below is rounded.
Matrix3d threeAxes() {
  Matrix3d axes;
  axes << 1, 2, -2,  //
      2, 1, 2,       //
      2, -2, -1;
  return axes;
}

// Of moments nine times these.
Matrix3d turnedTensor(const Vector3d& ninths) {
  return threeAxes() * ninths.asDiagonal() * threeAxes().transpose();
}

// Two descriptions of one body: along its principal axes, and turned within its own. Moments that
// are far apart or close together are as hard as its eigenvalues.
TEST(ExactTensor, MovesAsTheSameBodyAlongItsPrincipalAxes) {
  const Matrix3d bodyFromPrincipal = threeAxes() / 3;
  for (const Vector3d& ninths : {Vector3d(0.125, 1, 1.0625),
                                 {0x1p-7, 1, 1 + 0x1p-8},
                                 {0x1p-20, 1, 1 + 0x1p-21},
                                 {0x1p-20, 0.5, 0.5},
                                 {1, 1 + 0x1p-20, 1 + 0x1p-19},
                                 {3, 4, 5},
                                 {2, 2, 3}}) {
    const PrincipalAxes axes = principalAxes(turnedTensor(ninths));
    for (const Vector3d& third :
         {Vector3d(0.25, 0.5, 1), {-1, 0x1p-20, 0.5}, {0x1p-20, -1, 0x1p-22}, {0, 1, 0}}) {
      const ExactMotion straight(9 * ninths, 3 * third);
      const ExactRotation turned(axes, threeAxes() * third);
      for (const double time : {1.0, 7.7, 100.0}) {
        const Matrix3d expected =
            bodyFromPrincipal * straight.at(time).worldFromBody * bodyFromPrincipal.transpose();
        const Matrix3d error = turned.at(time).worldFromBody - expected;
        EXPECT_LT(error.cwiseAbs().maxCoeff(), kTurnedBound)
            << ninths.transpose() << " spun " << third.transpose() << " at " << time;
      }
    }
  }
}

// Taylor's series at 60 digits from these doubles.
TEST(ExactTensor, AgreesWithSixtyDigits) {
  Matrix3d tensor;
  tensor << 3.2563682777231064, -0.2748406227777449, -0.37337000547569726,  //
      -0.2748406227777449, 4.08977352429242, -0.5392295313929658,           //
      -0.37337000547569726, -0.5392295313929658, 4.653858197984473;
  const Eigen::Quaterniond attitude(0.54410673667981477778, 0.19181728491410192486,
                                    0.63997384157367686005, 0.50753075809181782184);
  const Vector3d velocity(-0.088386458541919084798, 3.3394205099194116375, 1.5676002922434723159);
  const ExactRotation::Moment moment =
      ExactRotation(principalAxes(tensor), Vector3d(1, 2, 3)).at(10);
  EXPECT_LT((moment.worldFromBody - attitude.toRotationMatrix()).norm(), kSixtyDigitBound);
  EXPECT_LT((moment.angularVelocity - attitude * velocity).norm(), 3 * kSixtyDigitBound);
}

TEST(ExactTensor, HasMomentsAndAxesOfTwiceTheDigits) {
  const PrincipalAxes axes = principalAxes(turnedTensor({0x1p-20, 1, 1 + 0x1p-21}));
  const DoubleDouble3 moments = axes.preciseMoments();
  const double expected[] = {9 * 0x1p-20, 9, 9 + 9 * 0x1p-21};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(std::fabs((moments[i] - expected[i]).high), 9 * kPairBound);
  }
  // Of the middle axis, but for its sign
  const DoubleDouble3 along = axes.alongPrincipal(threeAxes().col(1));
  EXPECT_EQ(along[0].high, 0);
  EXPECT_EQ(along[2].high, 0);
  EXPECT_LT(std::fabs((absolute(along[1]) - 3.0).high), 3 * kPairBound);
}

}  // namespace
}  // namespace rotatebook::rigid
