#include "physics/measure/measurement.h"

#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "physics/motion_start.h"
#include "rigid/rotation.h"

namespace rotatebook::physics {
namespace {

int largestComponent(const Eigen::Vector3d& v) {
  int axis = 0;
  v.cwiseAbs().maxCoeff(&axis);
  return axis;
}

// Returns the angle of a rotation, to rounding even if it is small. [degrees]
double angleDeg(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  return 2 * arcTangent(q.vec().norm(), std::abs(q.w())) * 180 / std::numbers::pi;
}

}  // namespace

Eigen::Vector3d spunAxisOf(const MotionSettings& settings, const rigid::PrincipalAxes& inertia) {
  const Eigen::Vector3d spin =
      inertia.bodyFromPrincipal.transpose() * initialAngularVelocity(settings);
  const Eigen::Vector3d axis = inertia.bodyFromPrincipal.col(largestComponent(spin));
  return axis[largestComponent(axis)] < 0 ? Eigen::Vector3d(-axis) : axis;
}

// Uses atan2, because the arc cosine of a number near 1 loses half the digits of a small angle.
double tiltDegOf(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& spunAxis,
                 const Eigen::Vector3d& momentum) {
  const Eigen::Vector3d axis = rotation * spunAxis;
  return arcTangent(axis.cross(momentum).norm(), axis.dot(momentum)) * 180 / std::numbers::pi;
}

double halfTurnTime(const Sample& before, const Sample& sample) {
  const double passed = sample.tiltDeg > before.tiltDeg ? kFarTiltDeg : kNearTiltDeg;
  const double share = (passed - before.tiltDeg) / (sample.tiltDeg - before.tiltDeg);
  const bool isBetween = share >= 0 && share <= 1 && sample.halfTurns == before.halfTurns + 1;
  return isBetween ? before.time + share * (sample.time - before.time) : sample.time;
}

TiltSide sideOf(double tiltDeg) {
  if (tiltDeg < kNearTiltDeg) return TiltSide::Near;
  return tiltDeg > kFarTiltDeg ? TiltSide::Far : TiltSide::None;
}

TiltSide sideOfCosine(double along, double length) {
  constexpr double kCosine = 0.5;  // of kNearTiltDeg, and of kFarTiltDeg with another sign
  if (along > kCosine * length) return TiltSide::Near;
  return along < -kCosine * length ? TiltSide::Far : TiltSide::None;
}

bool keepsItsShape(double stretchMin, double stretchMax) {
  return stretchMin >= kMinStretch && stretchMax <= kMaxStretch;
}

int HalfTurnCounter::count(double tiltDeg) {
  return countSide(sideOf(tiltDeg));
}

int HalfTurnCounter::countCosine(double along, double length) {
  return countSide(sideOfCosine(along, length));
}

int HalfTurnCounter::countSide(TiltSide side) {
  if (stopped_) return halfTurns_;
  if (side == TiltSide::None) return halfTurns_;
  if (side_ != TiltSide::None && side != side_) ++halfTurns_;
  side_ = side;
  return halfTurns_;
}

Measurement::Measurement(const MotionSettings& settings, Compared compared)
    : body_(withSameLayout(settings).body),
      inertia_(modelInertia(settings)),
      spunAxis_(spunAxisOf(settings, inertia_)),
      isExact_(settings.simulation.model == Model::Exact) {
  if (compared == Compared::WithExact) exact_.emplace(exactRotation(settings));
}

Sample Measurement::measure(double time, const BodyState& state) {
  const rigid::Polar polar = rigid::polarDecomposition(state.worldFromBody);
  Sample sample;
  sample.time = time;
  sample.attitude = continuedAttitude(polar.rotation);
  sample.angularVelocity = state.angularVelocity;
  sample.angularMomentum = state.angularMomentum;
  sample.kinetic = state.kinetic;
  sample.potential = state.potential;
  sample.rotational = state.rotational;
  sample.tiltDeg = tiltDegOf(polar.rotation, spunAxis_, state.angularMomentum);
  sample.stretchMin = polar.singularValues[2];
  sample.stretchMax = polar.singularValues[0];
  if (!keepsItsShape(sample.stretchMin, sample.stretchMax)) counter_.stop();
  sample.halfTurns = counter_.count(sample.tiltDeg);
  if (exact_) {
    const NudgedRotation::Moment exact = exact_->at(time);
    sample.errorDeg = angleDeg(exact.worldFromBody.transpose() * polar.rotation);
    sample.regime = regime(polar.rotation, state.angularVelocity, exact.regime);
  }
  sample.cage = drawnCage(state, body_);
  return sample;
}

Eigen::Quaterniond Measurement::continuedAttitude(const Eigen::Matrix3d& rotation) {
  Eigen::Quaterniond next(rotation);
  if (next.dot(attitude_) < 0) next.coeffs() = -next.coeffs();
  attitude_ = next;
  return next;
}

// The regime of the exact motion is constant between nudges, which the rounding of one sample could
// change if the spin is less than 1e-8 off the middle axis.
rigid::Regime Measurement::regime(const Eigen::Matrix3d& rotation,
                                  const Eigen::Vector3d& angularVelocity,
                                  rigid::Regime exact) const {
  if (isExact_) return exact;
  const Eigen::Matrix3d principalFromWorld = (rotation * inertia_.bodyFromPrincipal).transpose();
  return rigid::regimeOf(inertia_.moments, principalFromWorld * angularVelocity);
}

}  // namespace rotatebook::physics
