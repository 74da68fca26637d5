#include "base/srgb.h"

#include "base/elementary.h"

namespace rotatebook {
namespace {

double power(double base, double exponent) {
  return exponential(exponent * logarithm(base));
}

}  // namespace

double decodedSrgb(double value) {
  return value <= 0.04045 ? value / 12.92 : power((value + 0.055) / 1.055, 2.4);
}

double encodedSrgb(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * power(light, 1 / 2.4) - 0.055;
}

}  // namespace rotatebook
