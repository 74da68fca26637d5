// The range of the colours of springs. Inside the room only.
#pragma once

namespace rotatebook::overlay {

/// Rounds `value` > 0 up to 1, 2 or 5 times a power of ten.
double roundedUp(double value);

}  // namespace rotatebook::overlay
