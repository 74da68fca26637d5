// The elementary functions, with the same bits on every machine. C libraries compute them by
// methods that differ from version to version and from processor to processor, and so do their last
// digits; these use + - * / and the square root alone, which IEEE 754 rounds alike everywhere.
//
// Each result is computed to twice a double's precision, better than 2^-88 of its value, and
// rounded once: all results for ten million arguments of each function are correctly rounded, which
// is measured, not proven. NaN gives NaN; zeros keep their signs and infinities have their limits
// as in IEEE 754, section 9.
#pragma once

#include "base/double_double.h"

namespace rotatebook {

inline constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/// Largest angle, of either sign, that sine() and cosine() accept. [rad]
inline constexpr double kLargestAngle = 1e6;

/// Returns the sine of `x` [rad]; NaN if |x| > kLargestAngle. Uses a table of 128 angles around the
/// circle, and Taylor's series between them.
double sine(double x);
/// Returns the cosine of `x` [rad], computed like sine(); NaN if |x| > kLargestAngle.
double cosine(double x);

struct CosineSine {
  double cosine, sine;
};
/// Returns both, in the time of one, for an angle known to double-double precision [rad]; NaN if
/// its size exceeds kLargestAngle.
CosineSine cosineSine(DoubleDouble angle);

/// Returns the arc tangent of any `x`, in [-pi/2, pi/2]. [rad]
double arcTangent(double x);
/// Returns the direction of the point (x, y), in [-pi, pi]; arguments in the order of C's atan2.
/// [rad] Uses a table of 257 angles in each octant, and Taylor's series between them.
double arcTangent(double y, double x);

/// Returns e^x of any `x`; infinity above 709.78, 0 below -745.13. Uses a table of 2^(k/64), and
/// Taylor's series between its rows. (Tang 1989)
double exponential(double x);
/// Returns the natural logarithm of `x` >= 0; NaN if it is negative. Uses a table of 2^(k/64), and
/// the series of the inverse hyperbolic tangent between its rows. (Tang 1990)
double logarithm(double x);
/// Returns the hyperbolic tangent of any `x`.
double hyperbolicTangent(double x);
/// Returns the inverse hyperbolic sine of any `x`.
double inverseHyperbolicSine(double x);

/// Returns sqrt(x^2 + y^2) of any `x` and `y`; infinity if one of them is infinite or the result
/// exceeds the largest double.
double roundedHypotenuse(double x, double y);

}  // namespace rotatebook
