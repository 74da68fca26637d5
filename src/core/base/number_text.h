// Numbers as text, independent of the locale.
#pragma once

#include <string>

namespace rotatebook {

/// Shortest decimal text that reads back to exactly `value`. "nan", "inf" and "-inf" where it isn't
/// finite.
std::string shortestText(double value);

/// `value` rounded to `digits` significant digits, 1 to 17, for people; as printf's "%.*g".
std::string roundedText(double value, int digits);

}  // namespace rotatebook
