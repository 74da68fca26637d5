// Ticks of axes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/number_text.h"
#include "plot/plot.h"

namespace rotatebook::plot {
namespace {

// Beyond these, powers of ten are written as such.
constexpr double kSmallestPlain = 0.00099, kLargestPlain = 99'999;

std::string superscript(int exponent) {
  constexpr std::array<const char*, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char letter : std::to_string(exponent)) {
    text += letter == '-' ? "⁻" : kDigits[static_cast<std::size_t>(letter - '0')];
  }
  return text;
}

/// Returns the power of ten with that exponent, rounded once.
double powerOfTen(int exponent) {
  return std::stod("1e" + std::to_string(exponent));
}

/// Returns a step of 1, 2 or 5 times a power of ten, of which about `wanted` fit into `span`.
double roundStep(double span, int wanted) {
  const double raw = span / wanted;
  const double power = powerOfTen(static_cast<int>(std::floor(std::log10(raw))));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= 1.4 * factor * power) return factor * power;
  }
  return 10 * power;
}

/// Returns the part of a right angle of which about `wanted` fit into `span`. [degrees]
double degreeStep(double span, int wanted) {
  for (const double step : {10.0, 15.0, 30.0, 45.0}) {
    if (span / wanted <= 1.2 * step) return step;
  }
  return 90;
}

std::vector<Tick> linearTicks(double from, double to, int wanted, bool isInDegrees) {
  constexpr double kFewDegrees = 20;
  const bool isWide = isInDegrees && to - from > kFewDegrees;
  const double step = isWide ? degreeStep(to - from, wanted) : roundStep(to - from, wanted);
  const double slack = 1e-9 * (to - from);
  std::vector<Tick> ticks;
  for (auto n = static_cast<std::int64_t>(std::ceil((from - slack) / step));
       static_cast<double>(n) * step <= to + slack; ++n) {
    const double value = static_cast<double>(n) * step;
    ticks.push_back({value, tickText(value)});
  }
  return ticks;
}

/// Returns "10⁻³" rather than "0.001": the powers of an axis that has others look alike.
std::string powerText(int exponent) {
  if (exponent == 0) return "1";
  return exponent == 1 ? "10" : "10" + superscript(exponent);
}

std::vector<Tick> logarithmicTicks(double from, double to, int wanted) {
  const int first = static_cast<int>(std::floor(std::log10(from)));
  const int last = static_cast<int>(std::ceil(std::log10(to)));
  const int every = std::max(1, static_cast<int>(std::ceil(1.0 * (last - first) / wanted)));
  const bool isShort = 3 * std::log10(to / from) <= wanted + 1;  // room for 2 and 5, too
  const bool arePowers = from < kSmallestPlain || to > kLargestPlain;
  constexpr double kSlack = 1e-9;
  std::vector<Tick> ticks;
  const auto add = [&](double value, const std::string& label) {
    if (value < from * (1 - kSlack) || value > to * (1 + kSlack)) return;
    ticks.push_back({value, label});
  };
  for (int exponent = first; exponent <= last; ++exponent) {
    const double power = powerOfTen(exponent);
    const std::string label = arePowers ? powerText(exponent) : tickText(power);
    add(power, exponent % every == 0 ? label : "");
    if (every > 1) continue;
    for (int factor = 2; factor <= 9; ++factor) {
      const bool isLabelled = isShort && (factor == 2 || factor == 5);
      add(factor * power, isLabelled ? tickText(factor * power) : "");
    }
  }
  return ticks;
}

}  // namespace

std::string tickText(double value) {
  constexpr int kDigits = 6;
  const double size = std::fabs(value);
  const std::string sign = value < 0 ? "−" : "";
  if (size == 0 || (size >= kSmallestPlain && size <= kLargestPlain)) {
    return sign + roundedText(size, kDigits);
  }
  const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-12));
  const double factor = size / powerOfTen(exponent);
  const bool isPower = std::fabs(factor - 1) < 1e-9;
  return sign + (isPower ? "" : roundedText(factor, 3) + "·") + "10" + superscript(exponent);
}

std::vector<Tick> ticksOf(double from, double to, scene::Scale scale, int wanted,
                          bool isInDegrees) {
  return scale == scene::Scale::Linear ? linearTicks(from, to, wanted, isInDegrees)
                                       : logarithmicTicks(from, to, wanted);
}

}  // namespace rotatebook::plot
