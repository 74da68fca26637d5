#include "base/frame_rate.h"

#include <numeric>

#include "base/parsed_number.h"

namespace rotatebook {
namespace {

constexpr int kMaxTerm = 1'000'000;
constexpr int kMaxRate = 1'000;

bool isRate(int numerator, int denominator) {
  return denominator >= 1 && denominator <= kMaxTerm && numerator >= denominator &&
         numerator <= kMaxTerm && numerator <= std::int64_t{kMaxRate} * denominator;
}

}  // namespace

std::optional<FrameRate> parseFrameRate(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto numerator = parsedNumber<int>(text.substr(0, slash));
  const auto denominator =
      slash == std::string_view::npos ? 1 : parsedNumber<int>(text.substr(slash + 1));
  if (!numerator || !denominator || !isRate(*numerator, *denominator)) return std::nullopt;
  const int divisor = std::gcd(*numerator, *denominator);
  return FrameRate{*numerator / divisor, *denominator / divisor};
}

}  // namespace rotatebook
