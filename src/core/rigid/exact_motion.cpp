#include "rigid/exact_motion.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "base/elementary.h"
#include "rigid/rotation.h"

namespace rotatebook::rigid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr DoubleDouble kWholeTurn{6.283185307179586, 2.4492935982947064e-16};

// Returns cosine and sine of an angle of many turns, whose low double matters.
CosineSine turnBy(DoubleDouble angle) {
  return cosineSine(angle - kWholeTurn * std::nearbyint(angle.high / kWholeTurn.high));
}

DoubleDouble3 pairsOf(const Vector3d& v) {
  return {v[0], v[1], v[2]};
}

Vector3d roundedOf(const DoubleDouble3& v) {
  return {v[0].value(), v[1].value(), v[2].value()};
}

Matrix3d rotationAboutZ(CosineSine turn) {
  Matrix3d rotation;
  rotation << turn.cosine, -turn.sine, 0, turn.sine, turn.cosine, 0, 0, 0, 1;
  return rotation;
}

}  // namespace

ExactMotion::ExactMotion(const Vector3d& inertia, const Vector3d& angularVelocity)
    : ExactMotion(Start{pairsOf(inertia), pairsOf(angularVelocity)}) {}

ExactMotion::ExactMotion(const Start& start)
    : inertia_(roundedOf(withSameLayout(start).inertia)),
      start_(roundedOf(start.angularVelocity)),
      speed_(hypotenuse(hypotenuse(start.angularVelocity[0], start.angularVelocity[1]),
                        start.angularVelocity[2])),
      polhode_(polhodeOf(start.inertia, start.angularVelocity)),
      regime_(polhode_ ? polhode_->regime : preciseRegimeOf(start.inertia, start.angularVelocity)),
      jacobi_(polhode_ ? polhode_->k1 : 1),
      ellipticPi_(polhode_ ? polhode_->k1 : 1, polhode_ ? polhode_->n : 0) {
  if (!polhode_) return;
  inertia_ /= inertia_.maxCoeff();  // only the direction of the angular momentum is needed
  const double u = polhode_->start.value();
  startTurn_ = polhode_->weight.high * ellipticPi_.at(u, jacobi_.at(u));
  worldFromMomentum_ = bodyFromMomentum(start_);
}

double ExactMotion::flipInterval() const {
  if (!polhode_ || polhode_->halfPeriod.high == 0) return std::numeric_limits<double>::infinity();
  return (polhode_->halfPeriod / polhode_->rate).value();
}

ExactMotion::Moment ExactMotion::at(double time) const {
  return polhode_ ? polhodeAt(time) : steadyAt(time);
}

ExactMotion::Moment ExactMotion::steadyAt(double time) const {
  if (speed_.high == 0) return {start_, Matrix3d::Identity()};
  const CosineSine turn = turnBy(speed_ * time);
  const Vector3d axis = start_ / speed_.high;
  const Matrix3d cross = crossMatrix(axis);
  return {start_, Matrix3d::Identity() + turn.sine * cross + (1 - turn.cosine) * cross * cross};
}

Vector3d ExactMotion::angularVelocityBodyAt(double time) const {
  return polhode_ ? placeAt(time).angularVelocity : start_;
}

ExactMotion::Place ExactMotion::placeAt(double time) const {
  const Polhode& p = *polhode_;
  const DoubleDouble phase = p.rate * time + p.start;
  const double halves = p.halfPeriod.high > 0 ? std::nearbyint(phase.high / p.halfPeriod.high) : 0;
  const double u = (phase - p.halfPeriod * halves).value();
  const double sign = std::fmod(halves, 2) == 0 ? 1 : -1;

  const JacobiValues values = jacobi_.at(u);
  return {halves, u, values,
          sign * values.cn * p.cosine + sign * values.sn * p.sine + values.dn * p.delta};
}

// Turns the angular momentum's frame about it; each half-period left out adds the same turn.
ExactMotion::Moment ExactMotion::polhodeAt(double time) const {
  const Polhode& p = *polhode_;
  const auto [halves, u, values, w] = placeAt(time);
  const double part = p.weight.high * ellipticPi_.at(u, values) - startTurn_;
  const DoubleDouble turn = p.precession * time + p.weightedHalfPeriod * halves + part;
  return {w, worldFromMomentum_ * rotationAboutZ(turnBy(turn)) * bodyFromMomentum(w).transpose()};
}

// Returns the momentum's frame as columns: two axes perpendicular to it, and its direction.
Matrix3d ExactMotion::bodyFromMomentum(const Vector3d& angularVelocity) const {
  Matrix3d frame;
  const Vector3d direction = (inertia_.cwiseProduct(angularVelocity)).stableNormalized();
  const Vector3d across = direction.cross(polhode_->frameAxis).normalized();
  frame << across.cross(direction), across, direction;
  return frame;
}

}  // namespace rotatebook::rigid
