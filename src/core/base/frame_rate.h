// The frame rate of a clip as an exact fraction.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook {

/// Frames per second as a fraction in lowest terms, so that frame n is shown at exactly n *
/// denominator / numerator seconds.
struct FrameRate {
  int numerator = 60;   ///< > 0
  int denominator = 1;  ///< > 0

  /// Returns the duration of one frame. [s]
  double period() const { return static_cast<double>(denominator) / numerator; }
  /// Returns the number of frames in `seconds` >= 0, rounded to the nearest integer.
  std::int64_t framesIn(double seconds) const {
    return std::llround(seconds * numerator / denominator);
  }
  /// Returns "60" or "30000/1001", as scene files write it.
  std::string text() const {
    const std::string whole = std::to_string(numerator);
    return denominator == 1 ? whole : whole + "/" + std::to_string(denominator);
  }

  friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

/// Parses "60" or "30000/1001" into lowest terms; nullopt unless it is a rate from 1 to 1000 with
/// terms up to a million.
std::optional<FrameRate> parseFrameRate(std::string_view text);

}  // namespace rotatebook
