// Ranges of numbers, linear and logarithmic.
#pragma once

namespace rotatebook::scene {

/// The spacing of numbers in a range.
enum class Scale { Linear, Logarithmic };

/// Returns the number at `share` of the way from `low` to `high`, both over 0 if the scale is
/// logarithmic.
double numberWithin(double low, double high, double share, Scale scale);
/// Returns the share of the way at which `number` is, likewise; numbers outside the range have
/// shares outside 0 to 1. `low` and `high` differ.
double shareOf(double number, double low, double high, Scale scale);

}  // namespace rotatebook::scene
