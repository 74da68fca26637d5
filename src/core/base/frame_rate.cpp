#include "base/frame_rate.h"

#include <charconv>
#include <numeric>
#include <system_error>

namespace rotatebook {
namespace {

constexpr int kMaxTerm = 1'000'000;
constexpr int kMaxRate = 1'000;

// Returns all of `text` as an integer; nullopt if it isn't one.
std::optional<int> wholeNumber(std::string_view text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return number;
}

bool isRate(int numerator, int denominator) {
  return denominator >= 1 && denominator <= kMaxTerm && numerator >= denominator &&
         numerator <= kMaxTerm && numerator <= std::int64_t{kMaxRate} * denominator;
}

}  // namespace

std::optional<FrameRate> parseFrameRate(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto numerator = wholeNumber(text.substr(0, slash));
  const auto denominator =
      slash == std::string_view::npos ? 1 : wholeNumber(text.substr(slash + 1));
  if (!numerator || !denominator || !isRate(*numerator, *denominator)) return std::nullopt;
  const int divisor = std::gcd(*numerator, *denominator);
  return FrameRate{*numerator / divisor, *denominator / divisor};
}

}  // namespace rotatebook
