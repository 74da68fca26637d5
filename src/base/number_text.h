// Numbers as text that reads back to the same bits.
#pragma once

#include <string>

namespace rotatebook {

/// Shortest decimal text that reads back to exactly `value`; independent of the locale.
/// "nan", "inf" and "-inf" where it isn't finite.
std::string shortestText(double value);

}  // namespace rotatebook
