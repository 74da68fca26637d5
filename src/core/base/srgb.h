// sRGB's curve, with the same bits on every machine.
#pragma once

namespace rotatebook {

/// Returns the linear light of an sRGB value, both 0 to 1. (IEC 61966-2-1)
double decodedSrgb(double value);
/// Returns the sRGB value of linear light, both 0 to 1. (IEC 61966-2-1)
double encodedSrgb(double light);

}  // namespace rotatebook
