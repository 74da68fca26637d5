// Colours as people write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook {

/// An opaque colour, sRGB.
struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;

  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// Reads "#rrggbb", "white" or "black"; returns nothing for other texts.
std::optional<Rgb> parseRgb(std::string_view text);
/// Returns "#rrggbb".
std::string textOf(const Rgb& colour);

/// Returns the relative luminance, 0 of black to 1 of white, as WCAG 2.1 defines it but with 2 for
/// the exponent of sRGB: within 0.03.
constexpr double luminanceOf(double red, double green, double blue) {
  return 0.2126 * red * red + 0.7152 * green * green + 0.0722 * blue * blue;
}

}  // namespace rotatebook
