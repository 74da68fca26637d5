#include "base/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <system_error>

#include "base/elementary.h"
#include "base/parsed_number.h"
#include "base/text.h"

namespace rotatebook {
namespace {

/// A unit: multiplier 10^exponent, or multiplier pi / divisor, of the SI's.
struct Unit {
  std::string_view name;
  Dimension dimension;
  int multiplier = 1;
  int exponent = 0;
  int divisorOfPi = 0;  ///< 0 for units without pi.
};

constexpr std::array<Unit, 19> kUnits{{
    {"m", Dimension::Length},
    {"cm", Dimension::Length, 1, -2},
    {"mm", Dimension::Length, 1, -3},
    {"km", Dimension::Length, 1, 3},
    {"in", Dimension::Length, 254, -4},
    {"kg", Dimension::Mass},
    {"g", Dimension::Mass, 1, -3},
    {"s", Dimension::Time},
    {"ms", Dimension::Time, 1, -3},
    {"min", Dimension::Time, 60},
    {"rad", Dimension::Angle},
    {"deg", Dimension::Angle, 1, 0, 180},
    {"turn", Dimension::Angle, 2, 0, 1},
    {"°", Dimension::Angle, 1, 0, 180},
    {"rad/s", Dimension::AngularVelocity},
    {"deg/s", Dimension::AngularVelocity, 1, 0, 180},
    {"°/s", Dimension::AngularVelocity, 1, 0, 180},
    {"turn/s", Dimension::AngularVelocity, 2, 0, 1},
    {"rpm", Dimension::AngularVelocity, 1, 0, 30},
}};

/// Units that people write, but that aren't read; no other is meant by them.
constexpr std::array<std::string_view, 26> kOtherUnits{
    "grad", "gon", "arcmin", "arcsec", "mrad",    "mil",     "um",    "nm",     "dm",
    "ft",   "yd",  "mi",     "mg",     "t",       "lb",      "oz",    "us",     "ns",
    "h",    "hr",  "d",      "day",    "rad/min", "deg/min", "rad/h", "mrad/s",
};

/// Returns the digits of `number` times `multiplier`.
std::string multiplied(std::string number, int multiplier) {
  int carry = 0;
  for (auto digit = number.rbegin(); digit != number.rend(); ++digit) {
    carry += (*digit - '0') * multiplier;
    *digit = static_cast<char>('0' + carry % 10);
    carry /= 10;
  }
  return std::to_string(carry) + number;
}

/// Returns multiplier 10^exponent times a decimal number, correctly rounded; nothing if the
/// result, or the number's own exponent, is out of range.
std::optional<double> scaledDecimal(std::string_view number, int multiplier, int exponent) {
  const std::string sign = number.starts_with('-') ? "-" : "";
  number.remove_prefix(sign.size());

  // Take the digits as an integer, and what they leave out as an exponent
  const std::size_t end = std::min(number.find_first_of("eE"), number.size());
  std::string digits(number.substr(0, end));
  if (const std::size_t point = digits.find('.'); point != digits.npos) {
    digits.erase(point, 1);
    exponent -= static_cast<int>(digits.size() - point);
  }
  if (end < number.size()) {
    const auto own = parsedNumber<double>(number.substr(end + (number[end + 1] == '+' ? 2 : 1)));
    constexpr double kLargestExponent = 1e6;
    if (!own || std::fabs(*own) > kLargestExponent) return std::nullopt;
    exponent += static_cast<int>(*own);
  }
  return parsedNumber<double>(sign + multiplied(digits, multiplier) + "e" +
                              std::to_string(exponent));
}

/// A text that begins with a number.
struct SplitQuantity {
  double number = 0;  ///< finite
  std::string_view digits, unit;
};

std::optional<SplitQuantity> split(std::string_view text) {
  SplitQuantity quantity;
  const auto [rest, error] =
      std::from_chars(text.data(), text.data() + text.size(), quantity.number);
  if (error != std::errc() || !std::isfinite(quantity.number)) return std::nullopt;
  const auto length = static_cast<std::size_t>(rest - text.data());
  quantity.digits = text.substr(0, length);
  quantity.unit = trimmed(text.substr(length));
  return quantity;
}

}  // namespace

std::optional<double> parseQuantity(std::string_view text, Dimension dimension) {
  const std::optional<SplitQuantity> quantity = split(text);
  if (!quantity) return std::nullopt;
  const auto unit = std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& one) {
    return one.dimension == dimension && one.name == quantity->unit;
  });
  if (unit == kUnits.end()) return std::nullopt;

  if (unit->divisorOfPi == 0) {
    return scaledDecimal(quantity->digits, unit->multiplier, unit->exponent);
  }
  const double value = (kPi * unit->multiplier / unit->divisorOfPi * quantity->number).value();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string_view unitIn(std::string_view text) {
  const std::optional<SplitQuantity> quantity = split(text);
  return quantity ? quantity->unit : std::string_view();
}

bool isUnit(std::string_view name) {
  return std::ranges::count(kUnits, name, &Unit::name) > 0 ||
         std::ranges::count(kOtherUnits, name) > 0;
}

std::vector<std::string_view> unitsOf(Dimension dimension) {
  std::vector<std::string_view> names;
  for (const Unit& unit : kUnits) {
    if (unit.dimension == dimension) names.push_back(unit.name);
  }
  return names;
}

}  // namespace rotatebook
