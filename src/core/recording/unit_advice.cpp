#include "recording/unit_advice.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include "base/number_text.h"
#include "recording/rate_fit.h"
#include "recording/read_options.h"

namespace rotatebook::recording {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// A unit of rates.
struct RateUnit {
  double radians;
  std::string_view name;
  bool canBeStated;
};

constexpr std::array<RateUnit, 4> kRates{{{1, kRateUnits[0], true},
                                          {std::numbers::pi / 180, kRateUnits[1], true},
                                          {kTurn, "turns a second", false},
                                          {kTurn / 60, "turns a minute", false}}};
constexpr std::array<double, kTimeUnits.size()> kSeconds{1, 1e-3, 1e-6, 1e-9, 60};

bool areSame(double one, double other) {
  constexpr double kRounding = 1e-9;
  return std::abs(one / other - 1) < kRounding;
}

std::string ratesAdvice(const RateUnit& unit) {
  const std::string name(unit.name);
  if (!unit.canBeStated) return name + "? Write them in rad/s or deg/s";
  return name + "? State simulation.rates = \"" + name + "\", or --rates " + name;
}

std::string timesAdvice(const std::string& name) {
  return "are the times in " + name + "? State simulation.time_unit = \"" + name +
         "\", or --time-unit " + name;
}

/// Returns what to state instead, if these units explain the factor; else an empty text.
std::string adviceOn(double factor, const TableUnits& units, const RateUnit& rate,
                     std::size_t time) {
  const bool areRatesSame = areSame(rate.radians, units.radians);
  const bool areTimesSame = areSame(kSeconds[time], units.seconds);
  const double explained = units.radians / rate.radians * units.seconds / kSeconds[time];
  if (!isOne(factor / explained) || (areRatesSame && areTimesSame)) return "";
  const std::string timeName(kTimeUnits[time]), rateName(rate.name);
  if (areRatesSame) return timesAdvice(timeName);
  if (areTimesSame) return ratesAdvice(rate);
  if (!rate.canBeStated) return "";
  return rateName + ", and the times in " + timeName + "? State --rates " + rateName +
         " and --time-unit " + timeName + ", or simulation.rates and time_unit";
}

}  // namespace

std::string factorText(double factor, const TableUnits& units) {
  const std::string text =
      "the rates are " + roundedText(factor, 4) + " times the attitudes' slopes";
  for (const RateUnit& rate : kRates) {
    for (std::size_t time = 0; time < kSeconds.size(); ++time) {
      const std::string advice = adviceOn(factor, units, rate, time);
      if (!advice.empty()) return text + ": " + advice;
    }
  }
  return text + "; scale them";
}

}  // namespace rotatebook::recording
