#include "base/nearest_name.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/text.h"

namespace rotatebook {
namespace {

/// A word that people use for a name of this program.
struct OtherWord {
  std::string_view word, name;
};

constexpr std::array kOtherWords{
    // Keys and their values
    OtherWord{"cover", "front"},
    OtherWord{"dt", "step"},
    OtherWord{"timestep", "step"},
    OtherWord{"time_step", "step"},
    OtherWord{"step_size", "step"},
    OtherWord{"slow_motion", "speed"},
    OtherWord{"slowmotion", "speed"},
    OtherWord{"slow", "speed"},
    OtherWord{"playback_speed", "speed"},
    OtherWord{"frame_rate", "fps"},
    OtherWord{"framerate", "fps"},
    OtherWord{"resolution", "size"},
    OtherWord{"length", "duration"},
    OtherWord{"width", "size"},
    OtherWord{"height", "size"},
    OtherWord{"omega", "angular_velocity"},
    OtherWord{"spin", "angular_velocity"},
    OtherWord{"velocity", "angular_velocity"},
    OtherWord{"rotation", "angular_velocity"},
    OtherWord{"angle", "tilt"},
    OtherWord{"weight", "mass"},
    OtherWord{"moments", "inertia"},
    OtherWord{"fov", "field_of_view_deg"},
    OtherWord{"zoom", "field_of_view_deg"},
    OtherWord{"eye", "position"},
    OtherWord{"look_at", "target"},
    OtherWord{"bg", "background"},
    OtherWord{"blur", "motion_blur"},
    OtherWord{"antialias", "supersample"},
    OtherWord{"antialiasing", "supersample"},
    OtherWord{"method", "integrator"},
    OtherWord{"solver", "integrator"},
    OtherWord{"runge-kutta", "rk4"},
    OtherWord{"rungekutta", "rk4"},
    OtherWord{"language", "words"},
    OtherWord{"half-turns", "Flips"},
    OtherWord{"flips", "half_turns"},
    OtherWord{"colour", "color"},
    OtherWord{"colours", "colors"},
    OtherWord{"over", "key"},
    OtherWord{"spacing", "scale"},
    OtherWord{"logarithmic", "log"},
    OtherWord{"median", "middle"},
    OtherWord{"intermediate", "middle"},
    OtherWord{"minor", "smallest"},
    OtherWord{"major", "largest"},
    OtherWord{"deutsch", "german"},
    OtherWord{"de", "german"},
    OtherWord{"en", "english"},
    // Commands and options
    OtherWord{"spin", "info"},
    OtherWord{"body", "info"},
    OtherWord{"init", "new"},
    OtherWord{"sheet", "still"},
    OtherWord{"validate", "check"},
    OtherWord{"at", "time"},
    OtherWord{"force", "overwrite"},
    // Units
    OtherWord{"metre", "m"},
    OtherWord{"metres", "m"},
    OtherWord{"meter", "m"},
    OtherWord{"meters", "m"},
    OtherWord{"centimetres", "cm"},
    OtherWord{"centimeters", "cm"},
    OtherWord{"inch", "in"},
    OtherWord{"inches", "in"},
    OtherWord{"gram", "g"},
    OtherWord{"grams", "g"},
    OtherWord{"kilogram", "kg"},
    OtherWord{"kilograms", "kg"},
    OtherWord{"sec", "s"},
    OtherWord{"secs", "s"},
    OtherWord{"second", "s"},
    OtherWord{"seconds", "s"},
    OtherWord{"msec", "ms"},
    OtherWord{"milliseconds", "ms"},
    OtherWord{"minute", "min"},
    OtherWord{"minutes", "min"},
    OtherWord{"degree", "deg"},
    OtherWord{"degrees", "deg"},
    OtherWord{"radian", "rad"},
    OtherWord{"radians", "rad"},
    OtherWord{"turns", "turn"},
    OtherWord{"rev", "turn"},
    OtherWord{"revolutions", "turn"},
    OtherWord{"degrees/s", "deg/s"},
    OtherWord{"dps", "deg/s"},
    OtherWord{"rev/s", "turn/s"},
    OtherWord{"rps", "turn/s"},
    OtherWord{"rev/min", "rpm"},
    OtherWord{"1/min", "rpm"},
};

// Returns the edit distance in small letters, counting swapped neighbours as one edit (optimal
// string alignment).
std::size_t editDistance(std::string_view word, std::string_view other) {
  const std::string a = lowerCase(word), b = lowerCase(other);
  std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) edits[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) edits[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      edits[i][j] = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1, changed});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
    }
  }
  return edits[a.size()][b.size()];
}

/// Returns the one candidate that begins with `word`; none if it is short, or several do.
std::optional<std::string_view> completed(std::string_view word,
                                          std::span<const std::string_view> candidates) {
  constexpr std::size_t kShortest = 3;
  std::optional<std::string_view> found;
  for (const std::string_view candidate : candidates) {
    if (word.size() < kShortest || editDistance(word, candidate.substr(0, word.size())) > 0)
      continue;
    if (found) return std::nullopt;
    found = candidate;
  }
  return found;
}

}  // namespace

std::optional<std::string_view> nearestName(std::string_view word,
                                            std::span<const std::string_view> candidates) {
  for (const auto& [other, name] : kOtherWords) {
    if (editDistance(word, other) == 0 && std::ranges::count(candidates, name) > 0) return name;
  }
  if (const auto whole = completed(word, candidates)) return whole;
  std::optional<std::string_view> nearest;
  std::size_t fewest = 0;
  for (const std::string_view candidate : candidates) {
    // About one edit in three letters: with more, the suggestion would be a guess.
    const std::size_t longer = std::max(word.size(), candidate.size());
    const std::size_t shorter = std::min(word.size(), candidate.size());
    const std::size_t allowed = (longer + 1) / 3;
    if (longer - shorter > allowed) continue;
    const std::size_t edits = editDistance(word, candidate);
    if (edits > allowed || (nearest && edits >= fewest)) continue;
    nearest = candidate;
    fewest = edits;
  }
  return nearest;
}

std::string didYouMean(std::string_view word, std::span<const std::string_view> candidates) {
  const auto nearest = nearestName(word, candidates);
  return nearest ? "; did you mean " + quotedText(*nearest) + "?" : "";
}

std::string quotedList(std::span<const std::string_view> names, std::string_view lastWord) {
  std::vector<std::string> all;
  for (const std::string_view name : names) all.push_back(quotedText(name));
  return listed(all, lastWord);
}

}  // namespace rotatebook
