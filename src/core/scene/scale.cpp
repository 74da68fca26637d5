#include "scene/scale.h"

#include "base/elementary.h"

namespace rotatebook::scene {

double numberWithin(double low, double high, double share, Scale scale) {
  if (scale == Scale::Linear) return low * (1 - share) + high * share;
  return exponential(logarithm(low) * (1 - share) + logarithm(high) * share);
}

double shareOf(double number, double low, double high, Scale scale) {
  if (scale == Scale::Linear) return (number - low) / (high - low);
  return (logarithm(number) - logarithm(low)) / (logarithm(high) - logarithm(low));
}

}  // namespace rotatebook::scene
