#include "rigid/exact_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "rigid/exact_motion_values.h"
#include "rigid/free_rigid_body.h"
#include "rigid/rotation.h"

namespace rotatebook::rigid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Of the angular velocity in units of its start, of the attitude as it is.
constexpr double kReferenceBound = 2e-13;   // measured 4e-14, of which the inputs' rounding
constexpr double kExactInputBound = 3e-14;  // measured 4e-15
constexpr double kOrthogonalBound = 5e-15;  // measured 1.4e-15
constexpr double kInvariantBound = 5e-15;   // relative; measured 8e-16
constexpr double kStartBound = 5e-15;       // measured 7e-16
constexpr double kDerivativeBound = 1e-10;  // of the attitude, by differences; measured 1.3e-11
constexpr double kComposedBound = 1e-13;    // measured 2.8e-14

const Vector3d kBook(0.05 / 12, 0.0241 / 12, 0.0709 / 12);  // middle, smallest, largest
constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kTimes[] = {0, 0.01, 1, 7.7, 31, 100, -0.3, -100};

struct Start {
  Vector3d inertia, angularVelocity;
};

Vector3d vectorOf(const std::array<double, 3>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

Matrix3d matrixOf(const std::array<double, 9>& rows) {
  Matrix3d matrix;
  matrix << rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7], rows[8];
  return matrix;
}

double largest(const Matrix3d& matrix) {
  return matrix.cwiseAbs().maxCoeff();
}

struct Error {
  double angularVelocity, attitude;
};

Error errorOf(const FreeRigidBodyMotion& motion, const FreeRigidBodySample& sample) {
  const Vector3d start = vectorOf(motion.angularVelocity);
  const ExactMotion::Moment moment = ExactMotion(vectorOf(motion.inertia), start).at(sample.time);
  const Vector3d w = vectorOf(sample.angularVelocityBody);
  return {(moment.angularVelocityBody - w).norm() / start.norm(),
          largest(moment.worldFromBody - matrixOf(sample.worldFromBody))};
}

// Every kind of motion: generic ones in all octants and orders of axes, the separatrix, its
// neighbourhood, symmetric tops, spheres, spins about and near the axes, large and small units.
std::vector<Start> starts() {
  std::vector<Start> all;
  for (const auto* motions : {&kFreeRigidBodyMotions, &kExactMotionValues}) {
    for (const FreeRigidBodyMotion& motion : *motions) {
      all.push_back({vectorOf(motion.inertia), vectorOf(motion.angularVelocity)});
    }
  }
  std::mt19937 generator(19);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const Vector3d size = Vector3d(number(generator), number(generator), number(generator));
    const Vector3d squares = size.cwiseAbs2() + Vector3d::Constant(1e-3);
    const Vector3d w(number(generator), number(generator), number(generator));
    all.push_back({Vector3d::Constant(squares.sum()) - squares, 5 * w});
  }
  return all;
}

TEST(ExactMotion, AgreesWithTheReference) {
  for (const FreeRigidBodyMotion& motion : kFreeRigidBodyMotions) {
    for (const FreeRigidBodySample& sample : motion.samples) {
      const Error error = errorOf(motion, sample);
      EXPECT_LT(error.angularVelocity, kReferenceBound) << motion.name << " at " << sample.time;
      EXPECT_LT(error.attitude, kReferenceBound) << motion.name << " at " << sample.time;
    }
  }
}

TEST(ExactMotion, AgreesInEveryRegime) {
  for (const FreeRigidBodyMotion& motion : kExactMotionValues) {
    for (const FreeRigidBodySample& sample : motion.samples) {
      const Error error = errorOf(motion, sample);
      EXPECT_LT(error.angularVelocity, kExactInputBound) << motion.name << " at " << sample.time;
      EXPECT_LT(error.attitude, kExactInputBound) << motion.name << " at " << sample.time;
    }
  }
}

// Far off in time: Taylor integration of order 26 at 33 digits over one period and the rest, the
// turn of a period taken to the power of their number.
const FreeRigidBodyMotion kFarOff{
    "far_off",
    {0.6, 0.8, 1},
    {3, 0.5, -0.9},
    {{1e6,
      {3.0189699757516553, 0.28058943006655379, -0.93728748454994892},
      {0.90572165990259279, 0.41806393469307784, -0.069934407070011154,  //
       -0.27432972103333764, 0.45237306258422966, -0.84858813119553811,  //
       -0.32312765115517927, 0.78776973714220999, 0.52441144371745951}},
     {1e11,
      {2.8421468418002167, 1.2780070400696479, -0.50663517664387148},
      {0.65460844291998999, 0.741545563086627, 0.14696245889479201,      //
       -0.27067661710014346, 0.41142715963100568, -0.87032284887459166,  //
       -0.70584839407133915, 0.529941383725125, 0.47004273678295599}}}};

TEST(ExactMotion, IsAsGoodAfterMillionsOfTurns) {
  for (const FreeRigidBodySample& sample : kFarOff.samples) {
    const Error error = errorOf(kFarOff, sample);
    EXPECT_LT(error.angularVelocity, kExactInputBound) << sample.time;
    EXPECT_LT(error.attitude, kExactInputBound) << sample.time;
  }
  const double time = 1e11;
  const Matrix3d steady = ExactMotion({1, 2, 2}, {0, 3, 0}).at(time).worldFromBody;
  const Matrix3d turned = Eigen::AngleAxisd(3 * time, Vector3d::UnitY()).matrix();
  EXPECT_LT(largest(steady - turned), kExactInputBound);
}

// A forgotten sign of the axes' order runs the angular velocity backward.
TEST(ExactMotion, WouldShowTheWrongHandedness) {
  for (const FreeRigidBodyMotion& motion : kFreeRigidBodyMotions) {
    const Vector3d start = vectorOf(motion.angularVelocity);
    const ExactMotion exact(vectorOf(motion.inertia), start);
    double farthest = 0;
    for (const FreeRigidBodySample& sample : motion.samples) {
      const Vector3d w = exact.at(-sample.time).angularVelocityBody;
      farthest = std::max(farthest, (w - vectorOf(sample.angularVelocityBody)).norm());
    }
    EXPECT_GT(farthest, 0.1) << motion.name;
  }
}

// Two roundings of one spin, a unit in the last place apart, are different motions.
TEST(ExactMotion, TakesItsNumbersAsTheyAre) {
  const Vector3d inertia(3, 4, 6);
  const ExactMotion on(inertia, {2, 0.5, 1});
  const ExactMotion beside(inertia, {std::nextafter(2.0, 3), 0.5, 1});
  EXPECT_EQ(on.regime(), Regime::Separatrix);
  EXPECT_EQ(beside.regime(), Regime::AboutSmallest);
  EXPECT_EQ(on.flipInterval(), std::numeric_limits<double>::infinity());
  EXPECT_GT((on.at(100).angularVelocityBody - beside.at(100).angularVelocityBody).norm(), 0.1);
}

TEST(ExactMotion, StartsAsAsked) {
  for (const Start& start : starts()) {
    const ExactMotion::Moment moment = ExactMotion(start.inertia, start.angularVelocity).at(0);
    EXPECT_LT((moment.angularVelocityBody - start.angularVelocity).stableNorm(),
              kStartBound * start.angularVelocity.stableNorm());
    EXPECT_LT(largest(moment.worldFromBody - Matrix3d::Identity()), kStartBound);
  }
}

TEST(ExactMotion, IsARotation) {
  for (const Start& start : starts()) {
    const ExactMotion motion(start.inertia, start.angularVelocity);
    for (const double time : kTimes) {
      const Matrix3d r = motion.at(time).worldFromBody;
      EXPECT_LT(largest(r * r.transpose() - Matrix3d::Identity()), kOrthogonalBound);
      EXPECT_GT(r.determinant(), 0);
    }
  }
}

TEST(ExactMotion, KeepsMomentumAndEnergy) {
  for (const Start& start : starts()) {
    // Units in which no square under- or overflows.
    const double unit = std::ldexp(1, -std::ilogb(start.angularVelocity.cwiseAbs().maxCoeff()));
    const Vector3d w0 = unit * start.angularVelocity;
    const Vector3d momentum = start.inertia.cwiseProduct(w0);
    const double energy = w0.dot(momentum);
    const ExactMotion motion(start.inertia, start.angularVelocity);
    for (const double time : kTimes) {
      const auto [angularVelocity, r] = motion.at(time);
      const Vector3d w = unit * angularVelocity;
      const Vector3d momentumNow = r * start.inertia.cwiseProduct(w);
      EXPECT_LT((momentumNow - momentum).norm(), kInvariantBound * momentum.norm()) << time;
      EXPECT_NEAR(w.dot(start.inertia.cwiseProduct(w)), energy, kInvariantBound * energy) << time;
    }
  }
}

// R' = R [w]x, by differences of fourth order.
TEST(ExactMotion, TurnsByItsAngularVelocity) {
  for (const Start& start : starts()) {
    const ExactMotion motion(start.inertia, start.angularVelocity);
    const double speed = start.angularVelocity.stableNorm();
    const double h = 2e-3 / speed;
    for (const double time : {0.0, 3 / speed, 40 / speed, -200 / speed}) {
      const auto r = [&](int steps) { return motion.at(time + steps * h).worldFromBody; };
      const Matrix3d slope = (8 * (r(1) - r(-1)) - (r(2) - r(-2))) / 12;
      const auto [w, now] = motion.at(time);
      EXPECT_LT(largest(slope - now * crossMatrix(h * w)) / 2e-3, kDerivativeBound) << time;
      EXPECT_GT(largest(slope - now * crossMatrix(-h * w)) / 2e-3, 0.1);
    }
  }
}

// The motion from any moment is the same motion where no rounding of a start makes another.
TEST(ExactMotion, Composes) {
  for (const auto& [inertia, w] :
       {Start{kBook, {1.1, -2.3, -3.7}}, Start{kBook, {-1, 4, 0.5}},
        Start{{0.6, 0.8, 1}, {3, 0.5, -0.9}}, Start{{3, 3, 9}, {0, 5.0 / 3, 7.0 / 9}}}) {
    const ExactMotion motion(inertia, w);
    for (const double first : {0.4, -3.3, 20.0}) {
      const ExactMotion::Moment middle = motion.at(first);
      const ExactMotion rest(inertia, middle.angularVelocityBody);
      for (const double second : {0.7, 13.0, -8.0}) {
        const ExactMotion::Moment whole = motion.at(first + second), part = rest.at(second);
        EXPECT_LT((whole.angularVelocityBody - part.angularVelocityBody).norm(), kComposedBound);
        EXPECT_LT(largest(whole.worldFromBody - middle.worldFromBody * part.worldFromBody),
                  kComposedBound);
      }
    }
  }
}

TEST(ExactMotion, FlipsAtItsInterval) {
  const ExactMotion motion(kBook, {kFullTurn, 0, kFullTurn * 1e-6});
  const double interval = motion.flipInterval();
  EXPECT_NEAR(interval, 8.331085967875858, 1e-9);
  for (int i = 0; i < 12; ++i) {
    const double flip = (i + 0.5) * interval;
    EXPECT_NEAR(motion.at(flip).angularVelocityBody[0], 0, 1e-8);
    EXPECT_GT(motion.at(flip - 0.1).angularVelocityBody[0] * (i % 2 == 0 ? 1 : -1), 1);
    EXPECT_LT(motion.at(flip + 0.1).angularVelocityBody[0] * (i % 2 == 0 ? 1 : -1), -1);
  }
}

TEST(ExactMotion, NeverFlipsInASteadySpin) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const ExactMotion motion(kBook, -kFullTurn * Vector3d::Unit(axis));
    EXPECT_EQ(motion.flipInterval(), infinite);
    EXPECT_EQ(motion.at(100).angularVelocityBody, -kFullTurn * Vector3d::Unit(axis));
    const Matrix3d half = Eigen::AngleAxisd(-kFullTurn / 2, Vector3d::Unit(axis)).matrix();
    EXPECT_LT(largest(motion.at(30.5).worldFromBody - half), kExactInputBound);
  }
  EXPECT_EQ(ExactMotion({2, 2, 2}, {1, 2, 3}).flipInterval(), infinite);
  EXPECT_EQ(ExactMotion({2, 1, 2}, {1, 0, 3}).flipInterval(), infinite);
}

// Whatever underflows on the way: motions of the smallest components are finite, and start right.
TEST(ExactMotion, HoldsForTheSmallestComponents) {
  const double almost = 1 + 1e-10;
  for (const Vector3d& inertia : {kBook, Vector3d(1, 2, 2 * almost), Vector3d(1, almost, 2)}) {
    for (const double tiny : {5e-324, 1e-320, 1e-305, 1e-291, 1e-280, 1e-160}) {
      for (int axis = 0; axis < 3; ++axis) {
        for (int other = 0; other < 3; ++other) {
          if (other == axis) continue;
          const Vector3d w = 2 * Vector3d::Unit(axis) - tiny * Vector3d::Unit(other);
          const ExactMotion motion(inertia, w);
          EXPECT_LT((motion.at(0).angularVelocityBody - w).norm(), kStartBound) << w;
          const Matrix3d r = motion.at(3).worldFromBody;
          EXPECT_LT((r * inertia.cwiseProduct(w) - inertia.cwiseProduct(w)).norm(), kStartBound);
          const Matrix3d turned = Eigen::AngleAxisd(6, Vector3d::Unit(axis)).matrix();
          EXPECT_LT(largest(r - turned), kStartBound) << w;
        }
      }
    }
  }
}

TEST(ExactMotion, OfABodyAtRestIsRest) {
  const ExactMotion motion(kBook, {0, 0, 0});
  EXPECT_EQ(motion.regime(), Regime::Separatrix);
  EXPECT_EQ(motion.flipInterval(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(motion.at(1e6).angularVelocityBody, Vector3d(0, 0, 0));
  EXPECT_EQ(motion.at(1e6).worldFromBody, Matrix3d::Identity());
}

// A power of two in the inertia changes no bit; in the spin it is a change of the unit of time.
TEST(ExactMotion, HasNoScale) {
  const Vector3d w(1.1, -2.3, -3.7);
  const ExactMotion::Moment here = ExactMotion(kBook, w).at(17);
  for (const int exponent : {-40, 40, -900, 900}) {
    const double unit = std::ldexp(1, exponent);
    EXPECT_EQ(ExactMotion(unit * kBook, w).at(17).worldFromBody, here.worldFromBody);
    const ExactMotion::Moment scaled = ExactMotion(kBook, unit * w).at(17 / unit);
    EXPECT_EQ(scaled.worldFromBody, here.worldFromBody);
    EXPECT_EQ(scaled.angularVelocityBody, unit * here.angularVelocityBody);
  }
}

}  // namespace
}  // namespace rotatebook::rigid
