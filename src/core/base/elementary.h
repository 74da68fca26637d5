// The elementary functions, with the same bits on every machine. C libraries compute them by other
// means from version to version and from processor to processor, and their last digits differ;
// these use + - * / and the square root alone, which IEEE 754 rounds alike everywhere.
//
// Each is computed to twice a double's precision, better than 2^-88 of its value, and rounded once:
// of ten million arguments each all results are correctly rounded, which is measured, not proven.
// NaN gives NaN; zeros keep their signs and infinities have their limits as in IEEE 754, section 9.
#pragma once

#include "base/double_double.h"

namespace rotatebook {

inline constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/// The largest angle, either way, that sine() and cosine() take. [rad]
inline constexpr double kLargestAngle = 1e6;

/// The sine of `x` [rad]; NaN where |x| > kLargestAngle. By a table of 128 parts of a turn and
/// Taylor's series.
double sine(double x);
/// The cosine of `x` [rad]; NaN where |x| > kLargestAngle. As sine().
double cosine(double x);

struct CosineSine {
  double cosine, sine;
};
/// Both at once, in the time of one, of an angle that is known to twice a double's precision. [rad]
/// NaN where it is over kLargestAngle.
CosineSine cosineSine(DoubleDouble angle);

/// The arc tangent of any `x`, in [-pi/2, pi/2]. [rad]
double arcTangent(double x);
/// The direction of the point (x, y), in [-pi, pi]; arguments in the order of C's atan2. [rad] From
/// the nearest of 128 directions on by the arc tangent's series.
double arcTangent(double y, double x);

/// e^x of any `x`; infinite over 709.78, 0 under -745.13. By a table of 64 parts of a factor of 2
/// and Taylor's series. (Tang 1989)
double exponential(double x);
/// The natural logarithm of `x` >= 0; NaN of negative numbers. From the nearest of 64 parts of a
/// factor of 2 on by the area tangent's series. (Tang 1990)
double logarithm(double x);
/// The hyperbolic tangent of any `x`.
double hyperbolicTangent(double x);
/// The inverse hyperbolic sine of any `x`.
double inverseHyperbolicSine(double x);

/// sqrt(x^2 + y^2) of any `x` and `y`; infinite if one of them is, or if it is over the largest
/// number.
double roundedHypotenuse(double x, double y);

}  // namespace rotatebook
