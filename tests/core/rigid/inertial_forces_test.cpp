// The values of both frames were computed independently, in long double.
#include "rigid/inertial_forces.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "rigid/exact_rotation.h"
#include "rigid/rotation.h"

namespace rotatebook::rigid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kHeavy = 0.45, kLight = 0.05, kRadius = 0.15;  // [kg], [kg], [m]
constexpr double kRate = 5;                                     // about the middle axis, y [rad/s]
constexpr double kPrinted = 5.1e-10;  // the values' last digit; measured 4.9e-10

/// Tao's disc: two heavy masses on x, two light ones on y, all at the same distance.
struct WeightedDisc {
  Matrix3d inertia = Vector3d(2 * kLight, 2 * kHeavy, 2 * (kLight + kHeavy)).asDiagonal() *
                     Matrix3d::Identity() * (kRadius * kRadius);
  ExactRotation motion{principalAxes(inertia),
                       Vector3d(0, kRate* std::cos(0.01), kRate* std::sin(0.01))};

  Turning at(double time) const {
    return freeTurning(principalAxes(inertia), motion.angularVelocityBodyAt(time));
  }
  Matrix3d attitudeAt(double time) const { return motion.at(time).worldFromBody; }
};

/// Mass 0 is the heavy one at +x, mass 2 the light one at +y.
struct Weight {
  double mass;
  Vector3d place;
};
const Weight kWeight0{kHeavy, {kRadius, 0, 0}}, kWeight2{kLight, {0, kRadius, 0}};

void expectClose(const Vector3d& found, const Vector3d& expected) {
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), kPrinted) << found.transpose();
}

struct InBody {
  double time;
  Vector3d rate, centrifugal0, euler0, centrifugal2, euler2;
};

const std::array<InBody, 3> kInBody{{
    {0.5,
     {-0.258337796, 4.993071366, 0.236412035},
     {1.686599031, 0.087068186, 0.004122506},
     {0, -0.069654549, -0.004122506},
     {0.009674243, 0.000919718, -0.008853166},
     {0.007739394, 0, 0.008853166}},
    {1.5,
     {-3.668088566, -3.397444091, 3.281219118},
     {1.505859205, -0.841193493, 0.812416657},
     {0, 0.672954795, -0.812416657},
     {-0.093465944, 0.181659545, 0.083608189},
     {-0.074772755, 0, -0.083608189}},
    {2.0,
     {-0.464204249, -4.978153724, 0.418196586},
     {1.684590945, -0.155984407, 0.013103683},
     {0, 0.124787526, -0.013103683},
     {-0.017331601, 0.002927805, 0.015613852},
     {-0.013865281, 0, -0.015613852}},
}};

TEST(InertialForces, InTheBodysFrameAreTheValues) {
  const WeightedDisc disc;
  for (const InBody& row : kInBody) {
    const Turning body = disc.at(row.time);
    expectClose(body.rate, row.rate);
    const auto forces = [&](const Weight& weight) {
      return forcesIn(body, Matrix3d::Identity(), body, weight.place);
    };
    expectClose(kHeavy * forces(kWeight0).centrifugal, row.centrifugal0);
    expectClose(kHeavy * forces(kWeight0).euler, row.euler0);
    expectClose(kLight * forces(kWeight2).centrifugal, row.centrifugal2);
    expectClose(kLight * forces(kWeight2).euler, row.euler2);
  }
}

TEST(InertialForces, OfTheBodysFrameHoldEachMassAtRest) {
  const WeightedDisc disc;
  for (const double time : {0.0, 0.7, 1.3, 3.9}) {
    const Turning body = disc.at(time);
    for (const Weight& weight : {kWeight0, kWeight2}) {
      const ForcesPerMass forces = forcesIn(body, Matrix3d::Identity(), body, weight.place);
      EXPECT_EQ(forces.coriolis, Vector3d::Zero());
      EXPECT_LT(forces.sum().norm(), 1e-15);  // measured 0
    }
  }
}

TEST(InertialForces, CentrifugalAreTheWholeTorqueInTheBodysFrame) {
  const WeightedDisc disc;
  const Turning body = disc.at(1.1);
  Vector3d centrifugal = Vector3d::Zero(), euler = Vector3d::Zero();
  for (const Weight& weight : {kWeight0, kWeight2}) {
    for (const double side : {1, -1}) {
      const Vector3d place = side * weight.place;
      const ForcesPerMass forces = forcesIn(body, Matrix3d::Identity(), body, place);
      centrifugal += weight.mass * place.cross(forces.centrifugal);
      euler += weight.mass * place.cross(forces.euler);
    }
  }
  const Vector3d torque = disc.inertia * body.acceleration;
  EXPECT_GT(torque.norm(), 0.1);
  EXPECT_LT((centrifugal - torque).norm(), 1e-15);  // measured 4.7e-17
  EXPECT_LT((euler + torque).norm(), 1e-15);        // measured 3.9e-17
}

struct InSteadyFrame {
  double time;
  const Weight* weight;
  Vector3d place, centrifugal, coriolis, held;
};

const std::array<InSteadyFrame, 4> kInSteadyFrame{{
    {1.5,
     &kWeight0,
     {0.147011227, -0.010802287, 0.027767062},
     {1.653876303, 0, 0.312379449},
     {-0.182779106, 0, -0.020888349},
     {-1.460955953, -0.005247747, -0.401866109}},
    {0.5,
     &kWeight2,
     {-0.000134811, 0.149716718, -0.00921337},
     {-0.000168513, 0, -0.011516712},
     {0.019678589, 0, 0.005306678},
     {-0.017412803, -0.000933831, 0.000053731}},
    {1.5,
     &kWeight2,
     {0.013283605, -0.101367198, -0.109764462},
     {0.016604506, 0, -0.137205577},
     {-0.168107223, 0, -0.01568932},
     {0.148799226, 0.110646375, 0.164075044}},
    {2.0,
     &kWeight2,
     {0.000665415, -0.149473057, -0.012544415},
     {0.000831769, 0, -0.015680519},
     {-0.028584148, 0, -0.006917296},
     {0.030413409, 0.002475874, 0.007121239}},
}};

const Turning kSteady{{0, kRate, 0}, {0, 0, 0}};

Matrix3d steadyFromBody(const WeightedDisc& disc, double time) {
  return Eigen::AngleAxisd(-kRate * time, Vector3d::UnitY()).toRotationMatrix() *
         disc.attitudeAt(time);
}

ForcesPerMass steadyForces(const WeightedDisc& disc, double time, const Vector3d& place) {
  return forcesIn(kSteady, steadyFromBody(disc, time), disc.at(time), place);
}

TEST(InertialForces, InASteadyFrameAreTheValues) {
  const WeightedDisc disc;
  for (const InSteadyFrame& row : kInSteadyFrame) {
    const double mass = row.weight->mass;
    const ForcesPerMass forces = steadyForces(disc, row.time, row.weight->place);
    expectClose(steadyFromBody(disc, row.time) * row.weight->place, row.place);
    expectClose(mass * forces.centrifugal, row.centrifugal);
    expectClose(mass * forces.coriolis, row.coriolis);
    expectClose(mass * forces.held, row.held);
    EXPECT_EQ(forces.euler, Vector3d::Zero());
  }
}

TEST(InertialForces, AddUpToTheAccelerationInASteadyFrame) {
  const WeightedDisc disc;
  constexpr double kStep = 2e-3;
  for (const double time : {0.5, 1.31, 2.0}) {
    for (const Weight& weight : {kWeight0, kWeight2}) {
      const auto place = [&](double offset) -> Vector3d {
        return steadyFromBody(disc, time + offset * kStep) * weight.place;
      };
      // A difference of the sixth order
      const Vector3d acceleration = (2 * (place(3) + place(-3)) - 27 * (place(2) + place(-2)) +
                                     270 * (place(1) + place(-1)) - 490 * place(0)) /
                                    (180 * kStep * kStep);
      const Vector3d force = weight.mass * steadyForces(disc, time, weight.place).sum();
      EXPECT_LT((weight.mass * acceleration - force).norm(), 1e-10);  // measured 2.7e-11
    }
  }
}

}  // namespace
}  // namespace rotatebook::rigid
