#include "recording/held_readings.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rotatebook::recording {
namespace {

bool repeats(const std::vector<Rate>& rates, std::size_t index) {
  return index > 0 && rates[index].angularVelocity == rates[index - 1].angularVelocity;
}

/// Returns the number of rows for which readings are held; 1 if they aren't.
std::size_t heldRows(const std::vector<Rate>& rates) {
  constexpr double kTurning = 1;  // [rad/s]
  constexpr std::size_t kMostRows = 100, kFewestReadings = 5;
  constexpr std::size_t kPart = 10;  // of the rows that repeat the one before: a tenth
  std::size_t rows = 0, repeated = 0, run = 0, longest = 1;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (rates[i].angularVelocity.norm() < kTurning) continue;
    ++rows;
    run = repeats(rates, i) ? run + 1 : 1;
    if (run > 1) ++repeated;
    longest = std::max(longest, run);
  }
  const bool areHeld = longest > 1 && longest <= kMostRows && kPart * repeated >= rows &&
                       rows - repeated >= kFewestReadings;
  return areHeld ? longest : 1;
}

}  // namespace

std::string dropHeldReadings(std::vector<Rate>& rates) {
  const std::size_t held = heldRows(rates);
  if (held == 1) return "";
  std::vector<Rate> kept;
  std::size_t last = 0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (repeats(rates, i) && i - last < held) continue;
    last = i;
    kept.push_back(rates[i]);
  }
  const std::string all = std::to_string(rates.size());
  rates = std::move(kept);
  return "readings are repeated in up to " + std::to_string(held) +
         " rows, as where a table is faster than the gyroscope: the first row of each is taken, " +
         std::to_string(rates.size()) + " of " + all;
}

}  // namespace rotatebook::recording
