// Units that people write: "18.8 cm", "800 g", "1 deg", "60 rpm".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace rotatebook {

/// A kind of quantity, all of whose units convert into each other.
enum class Dimension { Length, Mass, Time, Angle, AngularVelocity };

/// Returns the SI value [m, kg, s, rad or rad/s] of a decimal number and a unit, with or without
/// spaces between them; nothing if `text` isn't a number with a unit of that dimension, or the
/// value isn't finite. The conversion is of the decimal number and rounded once: "18.8 cm" gives
/// the double that 0.188 is. Only where it involves pi is the decimal number rounded before.
std::optional<double> parseQuantity(std::string_view text, Dimension dimension);

/// Returns what follows the number that `text` begins with; empty if it begins with none.
std::string_view unitIn(std::string_view text);
/// Returns whether there is such a unit, of any dimension, though it may not be one that is read.
bool isUnit(std::string_view name);

/// Returns the names of the units of `dimension`, that of the SI first.
std::vector<std::string_view> unitsOf(Dimension dimension);

}  // namespace rotatebook
