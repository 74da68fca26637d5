#include "physics/exact/polhode.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary.h"
#include "physics/exact/elliptic.h"
#include "physics/measure/regime.h"

namespace rotatebook::physics {
namespace {

using Eigen::Vector3d;

// Of each of the body's axes in the motion: c, s and d are those about which w goes as cn, sn, dn.
struct AxisRoles {
  std::size_t c, s, d;
};

std::array<std::size_t, 3> ascendingAxes(const DoubleDouble3& inertia) {
  const auto [first, second, third] = axesByInertia(inertia);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(second),
          static_cast<std::size_t>(third)};
}

// Of the largest component.
int exponentOf(const DoubleDouble3& vector) {
  double largest = 0;
  for (const DoubleDouble& component : vector) {
    largest = std::max(largest, std::fabs(component.high));
  }
  return std::ilogb(largest);
}

DoubleDouble3 scaled(const DoubleDouble3& vector, int exponent) {
  return {scaled(vector[0], exponent), scaled(vector[1], exponent), scaled(vector[2], exponent)};
}

Vector3d unit(std::size_t axis) {
  return Vector3d::Unit(static_cast<Eigen::Index>(axis));
}

// Where L circles the axis of the largest moment that is the dn axis. About the smallest moment the
// motion is the same with the names of both axes exchanged.
AxisRoles axesOfMotion(const DoubleDouble3& inertia, double n2) {
  const auto [smallest, median, largest] = ascendingAxes(inertia);
  return n2 < 0 ? AxisRoles{largest, median, smallest} : AxisRoles{smallest, median, largest};
}

// +1 if the axes in the order of their moments are right-handed. Both orders of a AxisRoles are
// then the same turn, as far as the product of the three amplitudes' signs goes.
double handedness(const DoubleDouble3& inertia) {
  const auto [first, second, third] = ascendingAxes(inertia);
  return second == (first + 1) % 3 ? 1 : -1;
}

bool isSteady(const DoubleDouble3& inertia, const DoubleDouble3& w) {
  const auto hasTorque = [&](std::size_t i, std::size_t j) {
    return !(inertia[i] == inertia[j]) && w[i].high != 0 && w[j].high != 0;
  };
  return !hasTorque(0, 1) && !hasTorque(1, 2) && !hasTorque(2, 0);
}

DoubleDouble distance(DoubleDouble a, DoubleDouble b) {
  return absolute(a - b);
}

// The start of u from sn, |cn| and dn, without an inverse sn, which loses half of the digits where
// sn is near 1. Past K/2 it is measured from K.
DoubleDouble startOf(double sn, double cn, double dn, double k1, DoubleDouble k) {
  if (k1 == 0) return inverseHyperbolicSine(sn / cn);
  const double size = std::fabs(sn);
  if (cn >= size * dn) return sn * carlsonRF(cn * cn, dn * dn, 1);
  const double a = k1 * size / dn;
  const double b = k1 / dn;
  const DoubleDouble start = k - cn / dn * carlsonRF(a * a, b * b, 1);
  return sn < 0 ? -start : start;
}

// What the angular velocity and the attitude both hang on. Inertia and spin are scaled to near 1.
class PolhodeConstants {
 public:
  PolhodeConstants(const DoubleDouble3& inertia, const DoubleDouble3& w);

  bool isSteady() const;
  void setAngularVelocity(Polhode& polhode) const;
  void setAttitude(Polhode& polhode) const;

 private:
  DoubleDouble amplitudeC() const { return tilting_ / squareRoot(toD_ * ic_); }
  DoubleDouble amplitudeS() const { return tilting_ / squareRoot(sd_ * is_); }
  DoubleDouble amplitudeD() const { return circling_ / squareRoot(toD_ * id_); }
  DoubleDouble k1() const { return squareRoot(toD_ / sd_) * absolute(medianRoot_) / circling_; }
  DoubleDouble k() const { return squareRoot(cs_ / sd_) * tilting_ / circling_; }
  DoubleDouble rate() const { return circling_ * squareRoot(sd_ / (ic_ * is_ * id_)); }

  DoubleDouble3 w_;
  double handedness_;
  DoubleDouble medianRoot_;
  AxisRoles axes_;
  DoubleDouble ic_, is_, id_;
  DoubleDouble cs_, sd_, toD_;  // |Ic - Is|, |Is - Id|, |Ic - Id|
  DoubleDouble circling_;       // sqrt(N1) where d is the axis of the largest moment
  DoubleDouble tilting_;        // sqrt(N3)
};

DoubleDouble medianRootOf(const DoubleDouble3& inertia, const DoubleDouble3& w) {
  const auto [first, second, third] = ascendingAxes(inertia);
  return medianInvariantRoot({inertia[first], inertia[second], inertia[third]}, w[first], w[third]);
}

PolhodeConstants::PolhodeConstants(const DoubleDouble3& inertia, const DoubleDouble3& w)
    : w_(w),
      handedness_(handedness(inertia)),
      medianRoot_(medianRootOf(inertia, w)),
      axes_(axesOfMotion(inertia, medianRoot_.high)),
      ic_(inertia[axes_.c]),
      is_(inertia[axes_.s]),
      id_(inertia[axes_.d]),
      cs_(distance(ic_, is_)),
      sd_(distance(is_, id_)),
      toD_(distance(ic_, id_)),
      circling_(
          hypotenuse(squareRoot(cs_ * is_) * w[axes_.s], squareRoot(toD_ * id_) * w[axes_.d])),
      tilting_(
          hypotenuse(squareRoot(toD_ * ic_) * w[axes_.c], squareRoot(sd_ * is_) * w[axes_.s])) {}

// But for what would underflow. The last is a spin about the median axis.
bool PolhodeConstants::isSteady() const {
  constexpr double kNegligible = 1e-290, kNegligibleTilt = 1e-305;
  const double tilt = std::max(std::fabs(w_[axes_.c].high), std::fabs(w_[axes_.d].high));
  return circling_.high < kNegligible || tilting_.high < kNegligible || tilt < kNegligibleTilt;
}

void PolhodeConstants::setAngularVelocity(Polhode& polhode) const {
  const DoubleDouble modulus = k1();
  polhode.k1 = std::min(modulus.value(), 1.0);
  const DoubleDouble quarter =
      polhode.k1 > 0 ? completeIntegrals(modulus, 0.0).k : DoubleDouble(0.0);
  polhode.halfPeriod = quarter * 2.0;
  polhode.rate = rate();
  const double signC = std::copysign(1, w_[axes_.c].high);
  const double signD = std::copysign(1, w_[axes_.d].high);
  const double signS = handedness_ * signC * signD;
  const double c = amplitudeC().value(), s = amplitudeS().value(), d = amplitudeD().value();
  polhode.cosine = signC * c * unit(axes_.c);
  polhode.sine = signS * s * unit(axes_.s);
  polhode.delta = signD * d * unit(axes_.d);
  polhode.start = startOf(signS * w_[axes_.s].high / s, std::fabs(w_[axes_.c].high) / c,
                          std::fabs(w_[axes_.d].high) / d, polhode.k1, quarter);
}

// With M the amplitudes of L, e the frame's axis and o the other of c and d, the frame turns by
// |L| (Is ws^2 + Io wo^2) / (Ms^2 sn^2 + Lo^2), which is |L|/Io and a multiple of the integrand.
void PolhodeConstants::setAttitude(Polhode& polhode) const {
  const DoubleDouble momentumC = amplitudeC() * ic_;
  const DoubleDouble momentumD = amplitudeD() * id_;
  const DoubleDouble momentum = hypotenuse(momentumC, momentumD);
  const bool frameIsC = momentumC.high <= momentumD.high;
  const DoubleDouble io = frameIsC ? id_ : ic_;
  const DoubleDouble momentumO = frameIsC ? momentumD : momentumC;
  const DoubleDouble ratio = frameIsC ? momentumC / momentumD : k() * momentumD / momentumC;
  const DoubleDouble n = -(ratio * ratio);
  const DoubleDouble slope = amplitudeS() * is_ / momentumO;
  polhode.frameAxis = unit(frameIsC ? axes_.c : axes_.d);
  polhode.n = n.value();
  polhode.weight = momentum * (io - is_) / (io * is_) * slope * slope / rate();
  const DoubleDouble growth = DoubleDouble(1.0) / (DoubleDouble(1.0) - n);
  polhode.precession = momentum / io + polhode.weight * rate() * growth;
  if (polhode.k1 > 0) {
    const auto [k, j] = completeIntegrals(k1(), n);
    polhode.weightedHalfPeriod = polhode.weight * (j - k * growth) * 2.0;
  }
}

}  // namespace

std::optional<Polhode> polhodeOf(const DoubleDouble3& inertia,
                                 const DoubleDouble3& angularVelocity) {
  if (isSteady(inertia, angularVelocity)) return std::nullopt;
  // Neither unit matters to the shape of the motion.
  const int spin = exponentOf(angularVelocity);
  const PolhodeConstants constants(scaled(inertia, -exponentOf(inertia)),
                                   scaled(angularVelocity, -spin));
  if (constants.isSteady()) return std::nullopt;
  Polhode polhode;
  constants.setAngularVelocity(polhode);
  constants.setAttitude(polhode);
  const double unit = std::ldexp(1, spin);
  polhode.cosine *= unit;
  polhode.sine *= unit;
  polhode.delta *= unit;
  polhode.rate = polhode.rate * unit;
  polhode.precession = polhode.precession * unit;
  return polhode;
}

}  // namespace rotatebook::physics
