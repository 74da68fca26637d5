// A decimal number with more digits than a double has.
#pragma once

#include <cstdint>

namespace rotatebook::recording {

/// A number as a whole part and the rest, of the same sign.
struct Decimal {
  std::int64_t whole = 0;
  double rest = 0;  ///< In [0, 1), or (-1, 0].
};

}  // namespace rotatebook::recording
