#include "physics/polhode.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/elementary.h"
#include "physics/elliptic.h"
#include "physics/regime.h"

namespace rotatebook::physics {
namespace {

using Eigen::Vector3d;

// Of each of the body's axes in the motion: c, s and d are those about which w goes as cn, sn, dn.
struct Triple {
  int c, s, d;
};

// Where L circles the axis of the largest moment that is the dn axis. About the smallest moment the
// motion is the same with the names of both axes exchanged.
Triple axesOfMotion(const Vector3d& inertia, double n2) {
  const auto [smallest, median, largest] = axesByInertia(inertia);
  return n2 < 0 ? Triple{largest, median, smallest} : Triple{smallest, median, largest};
}

// +1 if the axes in the order of their moments are right-handed. Both orders of a Triple are then
// the same turn, as far as the product of the three amplitudes' signs goes.
double handedness(const Vector3d& inertia) {
  const auto [first, second, third] = axesByInertia(inertia);
  return (second - first + 3) % 3 == 1 ? 1 : -1;
}

bool isSteady(const Vector3d& inertia, const Vector3d& w) {
  const auto hasTorque = [&](int i, int j) {
    return inertia[i] != inertia[j] && w[i] != 0 && w[j] != 0;
  };
  return !hasTorque(0, 1) && !hasTorque(1, 2) && !hasTorque(2, 0);
}

DoubleDouble distance(double a, double b) {
  return absolute(exactSum(a, -b));
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
class Constants {
 public:
  Constants(const Vector3d& inertia, const Vector3d& w);

  bool isSteady() const;
  void setAngularVelocity(Polhode& polhode) const;
  void setAttitude(Polhode& polhode) const;

 private:
  DoubleDouble amplitudeC() const { return tilting_ / squareRoot(toD_ * ic_); }
  DoubleDouble amplitudeS() const { return tilting_ / squareRoot(sd_ * is_); }
  DoubleDouble amplitudeD() const { return circling_ / squareRoot(toD_ * id_); }
  DoubleDouble k1() const { return squareRoot(toD_ / sd_) * absolute(medianRoot_) / circling_; }
  DoubleDouble k() const { return squareRoot(cs_ / sd_) * tilting_ / circling_; }
  DoubleDouble rate() const {
    return circling_ * squareRoot(sd_ / (DoubleDouble(ic_) * is_ * id_));
  }

  Vector3d w_;
  double handedness_;
  DoubleDouble medianRoot_;
  Triple axes_;
  double ic_, is_, id_;
  DoubleDouble cs_, sd_, toD_;  // |Ic - Is|, |Is - Id|, |Ic - Id|
  DoubleDouble circling_;       // sqrt(N1) where d is the axis of the largest moment
  DoubleDouble tilting_;        // sqrt(N3)
};

DoubleDouble medianRootOf(const Vector3d& inertia, const Vector3d& w) {
  const auto [first, second, third] = axesByInertia(inertia);
  return medianInvariantRoot({inertia[first], inertia[second], inertia[third]}, w[first], w[third]);
}

Constants::Constants(const Vector3d& inertia, const Vector3d& w)
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
bool Constants::isSteady() const {
  constexpr double kNegligible = 1e-290, kNegligibleTilt = 1e-305;
  const double tilt = std::max(std::fabs(w_[axes_.c]), std::fabs(w_[axes_.d]));
  return circling_.high < kNegligible || tilting_.high < kNegligible || tilt < kNegligibleTilt;
}

void Constants::setAngularVelocity(Polhode& polhode) const {
  const DoubleDouble modulus = k1();
  polhode.k1 = std::min(modulus.value(), 1.0);
  const DoubleDouble quarter =
      polhode.k1 > 0 ? completeIntegrals(modulus, 0.0).k : DoubleDouble(0.0);
  polhode.halfPeriod = quarter * 2.0;
  polhode.rate = rate();
  const double signC = std::copysign(1, w_[axes_.c]);
  const double signD = std::copysign(1, w_[axes_.d]);
  const double signS = handedness_ * signC * signD;
  const double c = amplitudeC().value(), s = amplitudeS().value(), d = amplitudeD().value();
  polhode.cosine = signC * c * Vector3d::Unit(axes_.c);
  polhode.sine = signS * s * Vector3d::Unit(axes_.s);
  polhode.delta = signD * d * Vector3d::Unit(axes_.d);
  polhode.start = startOf(signS * w_[axes_.s] / s, std::fabs(w_[axes_.c]) / c,
                          std::fabs(w_[axes_.d]) / d, polhode.k1, quarter);
}

// With M the amplitudes of L, e the frame's axis and o the other of c and d, the frame turns by
// |L| (Is ws^2 + Io wo^2) / (Ms^2 sn^2 + Lo^2), which is |L|/Io and a multiple of the integrand.
void Constants::setAttitude(Polhode& polhode) const {
  const DoubleDouble momentumC = amplitudeC() * ic_;
  const DoubleDouble momentumD = amplitudeD() * id_;
  const DoubleDouble momentum = hypotenuse(momentumC, momentumD);
  const bool frameIsC = momentumC.high <= momentumD.high;
  const double io = frameIsC ? id_ : ic_;
  const DoubleDouble momentumO = frameIsC ? momentumD : momentumC;
  const DoubleDouble ratio = frameIsC ? momentumC / momentumD : k() * momentumD / momentumC;
  const DoubleDouble n = -(ratio * ratio);
  const DoubleDouble slope = amplitudeS() * is_ / momentumO;
  polhode.frameAxis = Vector3d::Unit(frameIsC ? axes_.c : axes_.d);
  polhode.n = n.value();
  polhode.weight =
      momentum * exactSum(io, -is_) / (DoubleDouble(io) * is_) * slope * slope / rate();
  const DoubleDouble growth = DoubleDouble(1.0) / (DoubleDouble(1.0) - n);
  polhode.precession = momentum / io + polhode.weight * rate() * growth;
  if (polhode.k1 > 0) {
    const auto [k, j] = completeIntegrals(k1(), n);
    polhode.weightedHalfPeriod = polhode.weight * (j - k * growth) * 2.0;
  }
}

}  // namespace

std::optional<Polhode> polhodeOf(const Vector3d& inertia, const Vector3d& angularVelocity) {
  if (isSteady(inertia, angularVelocity)) return std::nullopt;
  // Neither unit matters to the shape of the motion.
  const double spin = powerOfTwoBelow(angularVelocity.cwiseAbs().maxCoeff());
  const Constants constants(inertia / powerOfTwoBelow(inertia.maxCoeff()), angularVelocity / spin);
  if (constants.isSteady()) return std::nullopt;
  Polhode polhode;
  constants.setAngularVelocity(polhode);
  constants.setAttitude(polhode);
  polhode.cosine *= spin;
  polhode.sine *= spin;
  polhode.delta *= spin;
  polhode.rate = polhode.rate * spin;
  polhode.precession = polhode.precession * spin;
  return polhode;
}

}  // namespace rotatebook::physics
