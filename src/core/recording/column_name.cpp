#include "recording/column_name.h"

#include <algorithm>
#include <cstddef>

#include "base/text.h"
#include "recording/unit_tables.h"
#include "recording/words.h"

namespace rotatebook::recording {
namespace {

// Words that programs and messages write before the names of all columns.
constexpr std::string_view kContainers =
    "field header pose twist imu imu0 imu1 data msg message sensor sensors";
// Shimmer's program writes it after calibrated readings.
constexpr std::string_view kCalibrated = "cal";

bool isCapital(char letter) {
  return letter >= 'A' && letter <= 'Z';
}

bool isAmongLetters(char letter, std::string_view letters) {
  return letters.find(letter) != letters.npos;
}

bool isNumber(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

/// Returns the words between blanks and signs, and from a small letter to a capital one.
std::vector<std::string> wordsInName(std::string_view name) {
  constexpr std::string_view kBetween = " _-./:,%\t";
  std::vector<std::string> words(1);
  char before = ' ';
  for (const char letter : name) {
    const bool isBetween = isAmongLetters(letter, kBetween);
    const bool begins = isCapital(letter) && before >= 'a' && before <= 'z';
    if ((isBetween || begins) && !words.back().empty()) words.emplace_back();
    if (!isBetween) words.back() += lowerCase({&letter, 1});
    before = letter;
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// A header, taken apart into what is outside its brackets and within.
struct Bracketed {
  std::string outside, unit, numbers;
};

Bracketed bracketedOf(std::string_view header) {
  Bracketed result;
  while (true) {
    const std::size_t open = std::min(header.find_first_of("([{"), header.size());
    result.outside += header.substr(0, open);
    if (open == header.size()) return result;
    header.remove_prefix(open + 1);
    std::size_t end = 0;
    for (int depth = 0; end < header.size(); ++end) {  // "(m/(s^2))" has brackets within
      const bool closes = isAmongLetters(header[end], ")]}");
      if (closes && depth == 0) break;
      depth += isAmongLetters(header[end], "([{") ? 1 : closes ? -1 : 0;
    }
    std::string inside = lowerCase(header.substr(0, end));
    header.remove_prefix(std::min(end + 1, header.size()));
    std::erase(inside, ' ');
    const bool isAxis = inside == "x" || inside == "y" || inside == "z";
    if (isNumber(inside)) {
      result.numbers += inside;
    } else if (isAxis) {
      result.outside += ' ' + inside;
    } else if (result.unit.empty()) {
      result.unit = inside;
    }
  }
}

/// Returns what follows the last colon and, of a path that begins with a slash, its last two parts.
std::string_view endOfPath(std::string_view name) {
  name.remove_prefix(name.find_last_of(':') + 1);
  const std::size_t last = name.find_last_of('/');
  if (!name.starts_with('/') || last == 0) return name;
  return name.substr(name.find_last_of('/', last - 1) + 1);
}

bool isUnit(std::string_view name) {
  return unitNamed(kUnitsOfRates, name) || unitNamed(kUnitsOfAccelerations, name);
}

/// Takes the unit of up to three words off the end of `words`, of which one remains at least.
std::string takeUnit(std::vector<std::string>& words) {
  constexpr std::size_t kLongest = 3;
  for (std::size_t count = std::min(kLongest, words.size()); count > 0; --count) {
    if (count == words.size()) continue;
    std::string unit;
    for (std::size_t i = words.size() - count; i < words.size(); ++i) unit += words[i];
    if (!isUnit(unit)) continue;
    words.resize(words.size() - count);
    return unit;
  }
  return "";
}

/// Takes the unit at the end of `words`, or before an axis there.
std::string takeUnitAtEnd(std::vector<std::string>& words) {
  std::string unit = takeUnit(words);
  if (!unit.empty() || words.size() < 3 || !isAmong("x y z 0 1 2 3", words.back())) return unit;
  const std::string axis = words.back();
  words.pop_back();
  unit = takeUnit(words);
  words.push_back(axis);
  return unit;
}

void dropContainers(std::vector<std::string>& words) {
  const bool isShimmers = words.size() > 2 && words.front() == "shimmer";
  if (isShimmers) words.erase(words.begin(), words.begin() + 2);  // and the sensor's number
  while (words.size() > 1 && isAmong(kContainers, words.front())) words.erase(words.begin());
  if (words.size() > 1 && words.back() == kCalibrated) words.pop_back();
  // PASCO's "Time (s) Run #1"
  const bool isOfRun = words.size() > 2 && words[words.size() - 2] == "run";
  if (isOfRun && isNumber(words.back().substr(words.back().starts_with('#') ? 1 : 0)))
    words.resize(words.size() - 2);
}

/// Returns whether a part of a ROS message's path is called so.
bool isPart(std::string_view header, std::string_view part) {
  const std::size_t at = header.find(part);
  return at != header.npos && isAmongLetters((std::string(header) + ' ')[at + part.size()], "./");
}

}  // namespace

bool isOfRos(std::string_view header) {
  return isPart(header, "angular_velocity");
}

ColumnName columnNameOf(std::string_view header) {
  ColumnName name;
  const Bracketed parts = bracketedOf(header);
  name.words = wordsInName(endOfPath(parts.outside));
  dropContainers(name.words);
  std::vector<std::string> words = name.words;
  const std::string unit = takeUnitAtEnd(words);
  name.unit = parts.unit.empty() ? unit : parts.unit;
  for (const std::string& word : words) name.plain += word;
  // ROS's is with gravity, phyphox's "Linear Acceleration x" without.
  constexpr std::string_view kLinear = "linearacceleration";
  if (name.plain.starts_with(kLinear) && isPart(header, "linear_acceleration"))
    name.plain.replace(0, kLinear.size(), "specificforce");
  name.plain += parts.numbers;
  return name;
}

}  // namespace rotatebook::recording
