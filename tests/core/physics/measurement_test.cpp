#include "physics/measure/measurement.h"

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "physics/cage_fit.h"
#include "physics/scenarios.h"
#include "rigid/rotation.h"

namespace rotatebook::physics {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kMeasurementBound = 1e-14;  // measured 1.1e-15
constexpr double kDegreesBound = 1e-12;      // measured 1.5e-14
constexpr double kMeasuredTiltBound = 1e-7;  // relative; measured 1.2e-9
constexpr double kDegree = std::numbers::pi / 180;

int halfTurnsOf(std::initializer_list<double> tilts) {
  HalfTurnCounter counter;
  int count = 0;
  for (const double tilt : tilts) count = counter.count(tilt);
  return count;
}

BodyState stateOf(const Matrix3d& map, const Vector3d& angularMomentum = {0, 0, 1}) {
  BodyState state;
  state.worldFromBody = map;
  state.angularVelocity = {0, 0, 1};
  state.angularMomentum = angularMomentum;
  return state;
}

MotionSettings spinningAbout(const Vector3d& angularVelocity) {
  return spinning(Model::Quaternion, angularVelocity, 1);
}

Sample measureOne(const Matrix3d& map) {
  return Measurement(spinningAbout(Vector3d::UnitZ())).measure(0, stateOf(map));
}

Matrix3d someTurn() {
  return AngleAxisd(0.8, Vector3d(1, -2, 2) / 3).toRotationMatrix();
}

TEST(HalfTurnCounter, CountsFromUnderSixtyToOver120AndBack) {
  EXPECT_EQ(halfTurnsOf({1, 59}), 0);
  EXPECT_EQ(halfTurnsOf({1, 121}), 1);
  EXPECT_EQ(halfTurnsOf({1, 70, 110, 179}), 1);
  EXPECT_EQ(halfTurnsOf({1, 179, 1}), 2);
  EXPECT_EQ(halfTurnsOf({1, 179, 170, 5, 3, 175}), 3);
}

TEST(HalfTurnCounter, DoesNotCountAWobbleBetween) {
  EXPECT_EQ(halfTurnsOf({1, 119, 61, 119, 30}), 0);
  EXPECT_EQ(halfTurnsOf({1, 130, 61, 119, 61, 130}), 1);
  EXPECT_EQ(halfTurnsOf({1, 120, 1, 120}), 0);
  EXPECT_EQ(halfTurnsOf({130, 60, 130}), 0);
}

TEST(HalfTurnCounter, StartsOnEitherSideOrBetween) {
  EXPECT_EQ(halfTurnsOf({179, 1}), 1);
  EXPECT_EQ(halfTurnsOf({90, 179}), 0);
  EXPECT_EQ(halfTurnsOf({90, 1, 90, 179}), 1);
}

TEST(HalfTurnCounter, KeepsItsCountOnceStopped) {
  HalfTurnCounter counter;
  counter.count(1);
  EXPECT_EQ(counter.count(179), 1);
  counter.stop();
  EXPECT_EQ(counter.count(1), 1);
  EXPECT_EQ(counter.count(179), 1);
}

TEST(Measurement, CallsABodyABookUpToTwiceAndDownToHalfItsSize) {
  EXPECT_TRUE(keepsItsShape(1, 1));
  EXPECT_TRUE(keepsItsShape(0.579, 1.378));  // fig06, when its energy is all vibration
  EXPECT_TRUE(keepsItsShape(1, 1.849));      // fig11 at its last half-turn before the burst
  EXPECT_TRUE(keepsItsShape(0.5, 2));
  EXPECT_FALSE(keepsItsShape(0.499, 1));
  EXPECT_FALSE(keepsItsShape(1, 2.001));
  EXPECT_FALSE(keepsItsShape(2.2, 2.3));
}

// Turned about y by `degrees` and stretched along its own axes, with L along x, which was spun.
int halfTurnsAt(Measurement& measurement, double degrees, const Vector3d& stretch = {1, 1, 1}) {
  const Matrix3d turn = AngleAxisd(degrees * kDegree, Vector3d::UnitY()).toRotationMatrix();
  return measurement.measure(0, stateOf(turn * stretch.asDiagonal(), {1, 0, 0})).halfTurns;
}

TEST(Measurement, CountsNoHalfTurnsOfWhatIsNoLongerABook) {
  for (const Vector3d& burst : {Vector3d(1, 1, 2.1), Vector3d(0.4, 1, 1), Vector3d(3, 3, 3)}) {
    Measurement measurement(spinningAbout(Vector3d::UnitX()));
    EXPECT_EQ(halfTurnsAt(measurement, 0), 0);
    EXPECT_EQ(halfTurnsAt(measurement, 180, {1, 1.9, 0.6}), 1);  // deformed, but still a book
    EXPECT_EQ(halfTurnsAt(measurement, 0, burst), 1);
    EXPECT_EQ(halfTurnsAt(measurement, 180, burst), 1);
    EXPECT_EQ(halfTurnsAt(measurement, 0), 1);  // for good, whatever comes back
    EXPECT_EQ(halfTurnsAt(measurement, 180), 1);
  }
}

TEST(Measurement, FindsTheAttitudeOfARotatedBody) {
  const Sample sample = measureOne(someTurn());
  EXPECT_LT((sample.attitude.toRotationMatrix() - someTurn()).norm(), kMeasurementBound);
  EXPECT_NEAR(sample.stretchMin, 1, kMeasurementBound);
  EXPECT_NEAR(sample.stretchMax, 1, kMeasurementBound);
}

TEST(Measurement, FindsTheStretchOfADeformedBody) {
  const Sample sample = measureOne(someTurn() * Vector3d(1, 0.25, 1.5).asDiagonal());
  EXPECT_LT((sample.attitude.toRotationMatrix() - someTurn()).norm(), kMeasurementBound);
  EXPECT_NEAR(sample.stretchMin, 0.25, kMeasurementBound);
  EXPECT_NEAR(sample.stretchMax, 1.5, kMeasurementBound);
}

TEST(Measurement, FindsAProperRotationOfABodyTurnedInsideOut) {
  const Sample sample = measureOne(someTurn() * Vector3d(1, -0.25, 1.5).asDiagonal());
  EXPECT_LT((sample.attitude.toRotationMatrix() - someTurn()).norm(), kMeasurementBound);
  EXPECT_NEAR(sample.stretchMin, 0.25, kMeasurementBound);
}

// Particles drift: their map is fitted to corners that lie anywhere.
TEST(Measurement, DoesNotMindWhereTheBodyIs) {
  const auto measured = [](const body::Cage& cage) {
    BodyState state = stateOf(CageFit(body::Cuboid()).worldFromBody(cage));
    state.cage = cage;
    return Measurement(spinningAbout(Vector3d::UnitZ())).measure(0, state);
  };
  const body::Cage cage =
      someTurn() * Vector3d(1, 0.25, 1.5).asDiagonal() * body::Cuboid().corners();
  const Sample there = measured(cage.colwise() + Vector3d(0.1, -0.2, 0.3)), here = measured(cage);
  EXPECT_LT(there.attitude.angularDistance(here.attitude), kMeasurementBound);
  EXPECT_NEAR(there.stretchMin, here.stretchMin, kMeasurementBound);
  EXPECT_NEAR(there.stretchMax, here.stretchMax, kMeasurementBound);
  EXPECT_NEAR(there.stretchMin, 0.25, kMeasurementBound);
  EXPECT_NEAR(there.tiltDeg, here.tiltDeg, kDegreesBound);
  EXPECT_NEAR(there.errorDeg, here.errorDeg, kDegreesBound);
}

TEST(Measurement, ContinuesTheSignOfTheAttitude) {
  Measurement measurement(spinningAbout(Vector3d::UnitZ()));
  for (int degrees = 0; degrees <= 720; degrees += 30) {
    const Matrix3d turn = AngleAxisd(degrees * kDegree, Vector3d::UnitZ()).toRotationMatrix();
    const Quaterniond attitude = measurement.measure(0, stateOf(turn)).attitude;
    EXPECT_NEAR(attitude.w(), std::cos(degrees * kDegree / 2), kMeasurementBound) << degrees;
    EXPECT_NEAR(attitude.z(), std::sin(degrees * kDegree / 2), kMeasurementBound) << degrees;
  }
}

TEST(Measurement, TakesTheTiltOfTheMostSpunAxis) {
  const Matrix3d turn = AngleAxisd(40 * kDegree, Vector3d::UnitX()).toRotationMatrix();
  const auto tilt = [&](const Vector3d& spin, const Vector3d& momentum) {
    return Measurement(spinningAbout(spin)).measure(0, stateOf(turn, momentum)).tiltDeg;
  };
  EXPECT_NEAR(tilt({0, 0.1, 3}, {0, 0, 7}), 40, kDegreesBound);
  EXPECT_NEAR(tilt({0.1, -3, 1}, {0, 7, 0}), 40, kDegreesBound);
  EXPECT_NEAR(tilt({0, 3, 1}, {0, 0, 7}), 50, kDegreesBound);
  EXPECT_NEAR(tilt({3, 0, 1}, {7, 0, 0}), 0, kDegreesBound);
  EXPECT_NEAR(tilt({3, 0, 1}, {-7, 0, 0}), 180, kDegreesBound);
}

// The angular momentum's largest component may be along another axis.
TEST(Measurement, TakesTheAxisOfTheLargestAngularVelocity) {
  MotionSettings settings = spinningAbout({0, 1, 1.5});
  settings.initial.kind = InitialSpin::Kind::AngularMomentum;
  const Vector3d w = initialAngularVelocity(settings);
  ASSERT_GT(w.y(), w.z());
  EXPECT_NEAR(Measurement(settings).measure(0, stateOf(Matrix3d::Identity(), {0, 1, 0})).tiltDeg, 0,
              kDegreesBound);
}

TEST(Measurement, KeepsTheDigitsOfATinyTilt) {
  constexpr double kTilt = 1e-7;
  const Matrix3d turn = AngleAxisd(kTilt, Vector3d::UnitX()).toRotationMatrix();
  EXPECT_NEAR(measureOne(turn).tiltDeg * kDegree / kTilt, 1, kMeasuredTiltBound);
}

// About z the exact book turns by w t; here it has turned 1e-7, then 30 and 180 degrees more.
TEST(Measurement, MeasuresTheAngleToTheExactAttitude) {
  const auto errorDeg = [](double extra, const Vector3d& axis) {
    const Matrix3d exact = AngleAxisd(3 * 0.5, Vector3d::UnitZ()).toRotationMatrix();
    const Matrix3d turn = exact * AngleAxisd(extra * kDegree, axis).toRotationMatrix();
    return Measurement(spinningAbout({0, 0, 3})).measure(0.5, stateOf(turn)).errorDeg;
  };
  EXPECT_NEAR(errorDeg(0, Vector3d::UnitX()), 0, kDegreesBound);
  EXPECT_NEAR(errorDeg(1e-7, Vector3d::UnitY()), 1e-7, kDegreesBound);
  EXPECT_NEAR(errorDeg(30, Vector3d(1, -2, 2) / 3), 30, kDegreesBound);
  EXPECT_NEAR(errorDeg(-30, Vector3d::UnitX()), 30, kDegreesBound);
  EXPECT_NEAR(errorDeg(180, Vector3d::UnitY()), 180, kDegreesBound);
  EXPECT_NEAR(errorDeg(-170, Vector3d(1, -2, 2) / 3), 170, kDegreesBound);
}

TEST(Measurement, DerivesTheRegimeFromTheBodysAxes) {
  const Matrix3d turn = someTurn();
  const auto regime = [&](const MotionSettings& settings, const Vector3d& inBody) {
    BodyState state = stateOf(turn);
    state.angularVelocity = turn * inBody;
    return Measurement(settings).measure(0, state).regime;
  };
  const MotionSettings book = spinningAbout({1, 0, 0});
  EXPECT_EQ(regime(book, {5, 0, 0.01}), rigid::Regime::AboutLargest);
  EXPECT_EQ(regime(book, {5, 0.01, 0}), rigid::Regime::AboutSmallest);

  // Exchange the axes of largest and smallest moment by a tensor.
  MotionSettings turned = book;
  const Vector3d moments = book.body.solidInertia();
  turned.inertia = Vector3d(moments[0], moments[2], moments[1]).asDiagonal();
  EXPECT_EQ(regime(turned, {5, 0, 0.01}), rigid::Regime::AboutSmallest);
  EXPECT_EQ(regime(turned, {5, 0.01, 0}), rigid::Regime::AboutLargest);

  // Turn the body's axes away from the book's.
  const Matrix3d axes = AngleAxisd(1.1, Vector3d(2, 2, -1) / 3).toRotationMatrix();
  turned.inertia = axes * moments.asDiagonal() * axes.transpose();
  EXPECT_EQ(regime(turned, axes * Vector3d(5, 0, 0.01)), rigid::Regime::AboutLargest);
  EXPECT_EQ(regime(turned, axes * Vector3d(5, 0.01, 0)), rigid::Regime::AboutSmallest);
}

TEST(Measurement, PassesOnWhatTheSimulatorKnows) {
  BodyState state = stateOf(someTurn(), {1, 2, 3});
  state.angularVelocity = {4, 5, 6};
  state.kinetic = 7;
  state.potential = 8;
  state.rotational = 9;
  const Sample sample = Measurement(spinningAbout(Vector3d::UnitZ())).measure(1.5, state);
  EXPECT_EQ(sample.time, 1.5);
  EXPECT_EQ(sample.angularVelocity, state.angularVelocity);
  EXPECT_EQ(sample.angularMomentum, state.angularMomentum);
  EXPECT_EQ(sample.kinetic, 7);
  EXPECT_EQ(sample.potential, 8);
  EXPECT_EQ(sample.rotational, 9);
  EXPECT_EQ(sample.total(), 15);
}

TEST(Measurement, HasTheCornersOfTheCageOrOfTheMap) {
  Measurement measurement(spinningAbout(Vector3d::UnitZ()));
  BodyState state = stateOf(someTurn() * Vector3d(1, 0.25, 1.5).asDiagonal());
  EXPECT_EQ(measurement.measure(0, state).cage, state.worldFromBody * body::Cuboid().corners());
  state.cage = body::Cage::Random();
  EXPECT_EQ(measurement.measure(0, state).cage, *state.cage);
}

}  // namespace
}  // namespace rotatebook::physics
