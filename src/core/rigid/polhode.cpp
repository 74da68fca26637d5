#include "rigid/polhode.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary.h"
#include "base/elliptic.h"
#include "rigid/regime.h"

namespace rotatebook::rigid {
namespace {

using Eigen::Vector3d;

// The roles of the body's axes: w goes as cn about c, as sn about s, as dn about d.
struct AxisRoles {
  std::size_t c, s, d;
};

std::array<std::size_t, 3> ascendingAxes(const DoubleDouble3& inertia) {
  const auto [first, second, third] = axesByInertia(inertia);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(second),
          static_cast<std::size_t>(third)};
}

// Returns the binary exponent of the largest component.
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

// Chooses which axes carry cn, sn and dn. L circles the dn axis: that of the largest moment where
// N2 > 0, else that of the smallest, with the roles of both exchanged.
AxisRoles axesOfMotion(const DoubleDouble3& inertia, double n2) {
  const auto [smallest, middle, largest] = ascendingAxes(inertia);
  return n2 < 0 ? AxisRoles{largest, middle, smallest} : AxisRoles{smallest, middle, largest};
}

// Returns +1 if the axes in the order of their moments are right-handed, else -1. It is the product
// of the three amplitudes' signs, whichever axis L circles.
double handedness(const DoubleDouble3& inertia) {
  const auto [first, second, third] = ascendingAxes(inertia);
  return second == (first + 1) % 3 ? 1 : -1;
}

// Returns whether w x L is exactly 0.
bool isSteady(const DoubleDouble3& inertia, const DoubleDouble3& w) {
  const auto hasTorque = [&](std::size_t i, std::size_t j) {
    return !(inertia[i] == inertia[j]) && w[i].high != 0 && w[j].high != 0;
  };
  return !hasTorque(0, 1) && !hasTorque(1, 2) && !hasTorque(2, 0);
}

DoubleDouble distance(DoubleDouble a, DoubleDouble b) {
  return absolute(a - b);
}

// Returns u at t = 0 from sn, |cn| and dn. An inverse sn would lose half of the digits where sn is
// near 1; past K/2, u is measured from K.
DoubleDouble startPhase(double sn, double cn, double dn, double k1, DoubleDouble k) {
  if (k1 == 0) return inverseHyperbolicSine(sn / cn);
  const double size = std::fabs(sn);
  if (cn >= size * dn) return sn * carlsonRF(cn * cn, dn * dn, 1);
  const double a = k1 * size / dn;
  const double b = k1 / dn;
  const DoubleDouble start = k - cn / dn * carlsonRF(a * a, b * b, 1);
  return sn < 0 ? -start : start;
}

// Constants from which both the angular velocity and the attitude follow. Inertia and spin are
// scaled to near 1.
class PolhodeConstants {
 public:
  PolhodeConstants(const DoubleDouble3& inertia, const DoubleDouble3& w);

  bool isSteady() const;
  Polhode polhode() const;

 private:
  // Largest angular velocities about the axes
  struct Amplitudes {
    DoubleDouble c, s, d;
  };
  void setAttitude(const Amplitudes& amplitudes, Polhode& polhode) const;
  void setAngularVelocity(const Amplitudes& amplitudes, Polhode& polhode) const;

  DoubleDouble k1() const { return squareRoot(cd_ / sd_) * absolute(rootS_) / rootC_; }
  DoubleDouble k() const { return squareRoot(cs_ / sd_) * rootD_ / rootC_; }
  DoubleDouble rate() const { return rootC_ * squareRoot(sd_ / (ic_ * is_ * id_)); }

  DoubleDouble3 w_;
  double handedness_;
  DoubleDouble rootS_;  // sqrt|L^2 - 2 T Is|, with its sign
  AxisRoles axes_;
  DoubleDouble ic_, is_, id_;
  DoubleDouble cs_, sd_, cd_;  // |Ic - Is|, |Is - Id|, |Ic - Id|
  DoubleDouble rootC_;         // sqrt|L^2 - 2 T Ic|, without cancellation
  DoubleDouble rootD_;         // sqrt|L^2 - 2 T Id|, without cancellation
};

DoubleDouble middleRootOf(const DoubleDouble3& inertia, const DoubleDouble3& w) {
  const auto [first, second, third] = ascendingAxes(inertia);
  return middleInvariantRoot({inertia[first], inertia[second], inertia[third]}, w[first], w[third]);
}

PolhodeConstants::PolhodeConstants(const DoubleDouble3& inertia, const DoubleDouble3& w)
    : w_(w),
      handedness_(handedness(inertia)),
      rootS_(middleRootOf(inertia, w)),
      axes_(axesOfMotion(inertia, rootS_.high)),
      ic_(inertia[axes_.c]),
      is_(inertia[axes_.s]),
      id_(inertia[axes_.d]),
      cs_(distance(ic_, is_)),
      sd_(distance(is_, id_)),
      cd_(distance(ic_, id_)),
      rootC_(hypotenuse(squareRoot(cs_ * is_) * w[axes_.s], squareRoot(cd_ * id_) * w[axes_.d])),
      rootD_(hypotenuse(squareRoot(cd_ * ic_) * w[axes_.c], squareRoot(sd_ * is_) * w[axes_.s])) {}

// Returns whether the spin is steady apart from components that would underflow. The last condition
// finds a spin about the middle axis.
bool PolhodeConstants::isSteady() const {
  constexpr double kNegligible = 1e-290, kNegligibleTilt = 1e-305;
  const double tilt = std::max(std::fabs(w_[axes_.c].high), std::fabs(w_[axes_.d].high));
  return rootC_.high < kNegligible || rootD_.high < kNegligible || tilt < kNegligibleTilt;
}

Polhode PolhodeConstants::polhode() const {
  const Amplitudes amplitudes{rootD_ / squareRoot(cd_ * ic_), rootD_ / squareRoot(sd_ * is_),
                              rootC_ / squareRoot(cd_ * id_)};
  Polhode polhode;
  polhode.regime = static_cast<Regime>((rootS_.high > 0) - (rootS_.high < 0));
  polhode.rate = rate();
  setAttitude(amplitudes, polhode);
  setAngularVelocity(amplitudes, polhode);
  return polhode;
}

void PolhodeConstants::setAngularVelocity(const Amplitudes& amplitudes, Polhode& polhode) const {
  // Choose the amplitudes' signs, so that cn and dn start positive
  const double signC = std::copysign(1, w_[axes_.c].high);
  const double signD = std::copysign(1, w_[axes_.d].high);
  const double signS = handedness_ * signC * signD;
  const double c = amplitudes.c.value(), s = amplitudes.s.value(), d = amplitudes.d.value();
  polhode.cosine = signC * c * unit(axes_.c);
  polhode.sine = signS * s * unit(axes_.s);
  polhode.delta = signD * d * unit(axes_.d);

  // Find u at t = 0
  polhode.start = startPhase(signS * w_[axes_.s].high / s, std::fabs(w_[axes_.c].high) / c,
                             std::fabs(w_[axes_.d].high) / d, polhode.k1, polhode.halfPeriod * 0.5);
}

// Sets what completeIntegrals() gives, the period, too.
//
// The frame of L and an axis e, c or d, turns about L by |L| (Is ws^2 + Io wo^2) / (Ls^2 + Lo^2) a
// second, where o is the other of the two: |L|/Io plus a multiple of the integrand of J.
void PolhodeConstants::setAttitude(const Amplitudes& amplitudes, Polhode& polhode) const {
  // Choose the axis of the frame: c or d, about which L has the smaller amplitude
  const DoubleDouble momentumC = amplitudes.c * ic_;
  const DoubleDouble momentumD = amplitudes.d * id_;
  const DoubleDouble momentum = hypotenuse(momentumC, momentumD);
  const bool frameIsC = momentumC.high <= momentumD.high;
  polhode.frameAxis = unit(frameIsC ? axes_.c : axes_.d);

  // Find the integral's characteristic n and its weight
  const DoubleDouble io = frameIsC ? id_ : ic_;
  const DoubleDouble momentumO = frameIsC ? momentumD : momentumC;
  const DoubleDouble ratio = frameIsC ? momentumC / momentumD : k() * momentumD / momentumC;
  const DoubleDouble n = -(ratio * ratio);
  const DoubleDouble slope = amplitudes.s * is_ / momentumO;
  polhode.weight = momentum * (io - is_) / (io * is_) * slope * slope / polhode.rate;

  // Move the integral's growth into the precession, so that the rest is bounded
  const DoubleDouble growth = DoubleDouble(1.0) / (DoubleDouble(1.0) - n);
  polhode.precession = momentum / io + polhode.weight * polhode.rate * growth;
  polhode.n = n.value();

  // Find the period, and by how much half of it turns the frame beyond the precession
  const DoubleDouble modulus = k1();
  polhode.k1 = std::min(modulus.value(), 1.0);
  if (polhode.k1 == 0) return;
  const auto [k, j] = completeIntegrals(modulus, n);
  polhode.halfPeriod = k * 2.0;
  polhode.weightedHalfPeriod = polhode.weight * (j - k * growth) * 2.0;
}

}  // namespace

std::optional<Polhode> polhodeOf(const DoubleDouble3& inertia,
                                 const DoubleDouble3& angularVelocity) {
  if (isSteady(inertia, angularVelocity)) return std::nullopt;
  // Scale inertia and spin to near 1: neither unit matters to the shape of the motion
  const int spin = exponentOf(angularVelocity);
  const PolhodeConstants constants(scaled(inertia, -exponentOf(inertia)),
                                   scaled(angularVelocity, -spin));
  if (constants.isSteady()) return std::nullopt;

  // Scale back to the spin's unit
  Polhode polhode = constants.polhode();
  const double spinUnit = std::ldexp(1, spin);
  polhode.cosine *= spinUnit;
  polhode.sine *= spinUnit;
  polhode.delta *= spinUnit;
  polhode.rate = polhode.rate * spinUnit;
  polhode.precession = polhode.precession * spinUnit;
  return polhode;
}

}  // namespace rotatebook::rigid
