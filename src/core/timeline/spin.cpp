#include "timeline/spin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/double_double.h"
#include "base/elementary.h"
#include "physics/measure/exact_tilt.h"
#include "physics/measure/measurement.h"
#include "physics/motion_start.h"
#include "rigid/polhode.h"

namespace rotatebook::timeline {
namespace {

using rigid::PrincipalAxes;
using rigid::Regime;

constexpr DoubleDouble kTurn = kPi * 2.0;

/// Moments and angular velocity along the principal axes, those of the smallest moment first.
struct Sorted {
  DoubleDouble3 inertia, spin;
  std::array<int, 3> axes;  ///< Columns of PrincipalAxes::bodyFromPrincipal.
};

Sorted sortedOf(const PrincipalAxes& inertia, const DoubleDouble3& spin) {
  const DoubleDouble3 moments = inertia.preciseMoments();
  Sorted sorted{{}, {}, rigid::axesByInertia(moments)};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(sorted.axes[i]);
    sorted.inertia[i] = moments[axis];
    sorted.spin[i] = spin[axis];
  }
  return sorted;
}

EqualMoments equalOf(const DoubleDouble3& inertia) {
  const bool small = inertia[0] == inertia[1], large = inertia[1] == inertia[2];
  if (small && large) return EqualMoments::All;
  if (small) return EqualMoments::TwoSmallest;
  return large ? EqualMoments::TwoLargest : EqualMoments::None;
}

/// Returns a spin about the axis of a turned symmetric top, or across it, as exactly that: the
/// directions of both are rounded to doubles, and such a difference never grows.
DoubleDouble3 withoutRounding(DoubleDouble3 spin, const PrincipalAxes& inertia) {
  constexpr double kRounding = 1e-15;  // Of the spin; measured 2e-16.
  const bool isTurned = !inertia.bodyFromPrincipal.isIdentity(0);
  if (!isTurned || equalOf(sortedOf(inertia, spin).inertia) == EqualMoments::None) return spin;
  const double size = hypotenuse(hypotenuse(spin[0], spin[1]), spin[2]).high;
  for (DoubleDouble& part : spin) {
    if (std::fabs(part.high) < kRounding * size) part = 0.0;
  }
  return spin;
}

DoubleDouble twiceEnergy(const Sorted& s) {
  DoubleDouble sum;
  for (std::size_t i = 0; i < 3; ++i) sum = sum + s.inertia[i] * s.spin[i] * s.spin[i];
  return sum;
}

DoubleDouble momentumOf(const Sorted& s) {
  return hypotenuse(hypotenuse(s.inertia[0] * s.spin[0], s.inertia[1] * s.spin[1]),
                    s.inertia[2] * s.spin[2]);
}

/// Returns the period of a motion that has one. The turn is that of a frame of L and the axis about
/// which w goes as cn; the frame with the circled axis turns once more in each period, or less.
std::optional<SpinPeriod> periodOf(const PrincipalAxes& inertia, const DoubleDouble3& spin,
                                   const Sorted& sorted, Regime regime) {
  const auto polhode = rigid::polhodeOf(inertia.preciseMoments(), spin);
  if (!polhode || polhode->halfPeriod.high == 0) return std::nullopt;
  const DoubleDouble time = polhode->halfPeriod * 2.0 / polhode->rate;
  const bool aboutLargest = regime == Regime::AboutLargest;
  const DoubleDouble winding = aboutLargest ? kTurn : -kTurn;
  DoubleDouble turn = polhode->precession * time + polhode->weightedHalfPeriod * 2.0;
  const int circled = sorted.axes[aboutLargest ? 2 : 0];
  if (polhode->frameAxis[circled] != 0) turn = turn - winding;
  const DoubleDouble dynamic = twiceEnergy(sorted) / momentumOf(sorted) * time;
  return SpinPeriod{time.value(), turn.value(), dynamic.value(), (turn - dynamic).value(),
                    (turn + winding).value()};
}

/// Sets what is about the axis nearest to the spin.
void setSpunAxis(const Sorted& sorted, Spin& spin) {
  const auto size = [&](std::size_t i) { return std::fabs(sorted.spin[i].high); };
  for (std::size_t i = 1; i < 3; ++i) {
    if (size(i) > size(spin.spunAxis)) spin.spunAxis = i;
  }
  const std::size_t axis = spin.spunAxis, one = (axis + 1) % 3, other = (axis + 2) % 3;
  const double across = roundedHypotenuse(size(one), size(other));
  spin.offAxis = arcTangent(across, size(axis));

  const auto& moments = spin.moments;
  const double first = moments[one] - moments[axis], second = moments[other] - moments[axis];
  if (first == 0 || second == 0) return;
  const double rate = roundedHypotenuse(size(axis), across) *
                      std::sqrt(std::fabs(first * second) / (moments[one] * moments[other]));
  (axis == 1 ? spin.growth : spin.oscillation) = rate;
}

/// Sets the distances to the separatrix, from sqrt|L^2 - 2 E I2|, which has lost no digits.
void setMargin(const Sorted& sorted, Spin& spin) {
  const auto& [i1, i2, i3] = spin.moments;
  const double root =
      rigid::middleInvariantRoot(sorted.inertia, sorted.spin[0], sorted.spin[2]).value();
  const double share = root / std::sqrt(2 * spin.energy * i2);
  spin.margin = share * std::fabs(share);

  // The separatrix is two planes through the middle axis; their normals have these components
  const double n1 = std::sqrt(i1 * (i2 - i1)), n3 = std::sqrt(i3 * (i3 - i2));
  const double sum = n1 * std::fabs(sorted.spin[0].high) + n3 * std::fabs(sorted.spin[2].high);
  spin.toSeparatrix = 0;
  if (sum == 0) return;
  const double length = roundedHypotenuse(n1, n3) * spin.angularVelocity.norm();
  const double sine = std::fabs(root) / sum * (std::fabs(root) / length);
  spin.toSeparatrix = arcTangent(sine, std::sqrt(std::max(0.0, (1 - sine) * (1 + sine))));
}

/// Returns the time within one period at which the spun axis' angle to L passes 120 degrees.
std::optional<double> firstFlipOf(physics::MotionSettings settings, double period) {
  constexpr int kLooks = 512, kHalvings = 60;
  settings.nudges.clear();
  const physics::ExactTilt tilt(settings);
  const auto isOver = [&](double time) {
    return physics::sideOf(tilt.degAt(time)) == physics::TiltSide::Far;
  };
  double step = period / kLooks, time = step;
  while (time < period && !isOver(time)) time += step;
  if (time >= period) return std::nullopt;
  for (int i = 0; i < kHalvings; ++i) {
    step /= 2;
    if (isOver(time - step)) time -= step;
  }
  return time;
}

}  // namespace

std::optional<double> Spin::flipInterval() const {
  return firstFlip ? std::optional(period->time / 2) : std::nullopt;
}

Spin spinOf(const physics::MotionSettings& settings) {
  const PrincipalAxes inertia = rigid::withEqualMoments(modelInertia(settings));
  const DoubleDouble3 along = withoutRounding(settings.initial.alongPrincipal(inertia), inertia);
  const Sorted sorted = sortedOf(inertia, along);

  Spin spin;
  for (std::size_t i = 0; i < 3; ++i) {
    spin.moments[i] = sorted.inertia[i].value();
    spin.axes[i] = inertia.bodyFromPrincipal.col(sorted.axes[i]);
  }
  spin.equal = equalOf(sorted.inertia);
  spin.angularVelocity = initialAngularVelocity(settings);
  spin.angularMomentum = inertia.angularMomentum(spin.angularVelocity);
  spin.energy = twiceEnergy(sorted).value() / 2;
  spin.isSteady = !rigid::polhodeOf(inertia.preciseMoments(), along).has_value();
  spin.regime = rigid::preciseRegimeOf(inertia.preciseMoments(), along);
  setSpunAxis(sorted, spin);
  spin.period = periodOf(inertia, along, sorted, spin.regime);
  if (spin.equal == EqualMoments::None) setMargin(sorted, spin);
  if (spin.period && spin.equal == EqualMoments::None && spin.spunAxis != spin.circledAxis())
    spin.firstFlip = firstFlipOf(settings, spin.period->time);
  return spin;
}

}  // namespace rotatebook::timeline
