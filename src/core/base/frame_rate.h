// The rate of a clip as an exact fraction.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook {

/// Frames a second as a fraction in lowest terms, so that frame n lies at n * denominator /
/// numerator seconds exactly.
struct FrameRate {
  int numerator = 60;   ///< > 0
  int denominator = 1;  ///< > 0

  /// Length of one frame. [s]
  double period() const { return static_cast<double>(denominator) / numerator; }
  /// Number of whole frames within `seconds` (>= 0), rounded to nearest.
  std::int64_t framesIn(double seconds) const {
    return std::llround(seconds * numerator / denominator);
  }
  /// "60" or "30000/1001", as a scene file has it.
  std::string text() const {
    const std::string whole = std::to_string(numerator);
    return denominator == 1 ? whole : whole + "/" + std::to_string(denominator);
  }

  friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

/// "60" or "30000/1001" in lowest terms; nothing if it isn't a rate from 1 to 1000 with terms up to
/// a million.
std::optional<FrameRate> parseFrameRate(std::string_view text);

}  // namespace rotatebook
