// Numbers as text, independent of the locale.
#pragma once

#include <string>

namespace rotatebook {

/// Returns the shortest decimal text that reads back as exactly `value`; "nan", "inf" or "-inf" if
/// it isn't finite.
std::string shortestText(double value);

/// Returns `value` rounded to `digits` significant digits, 1 to 17, for people; like printf's
/// "%.*g".
std::string roundedText(double value, int digits);

}  // namespace rotatebook
