#include "recording/column_name.h"

#include <algorithm>
#include <cstddef>

namespace rotatebook::recording {
namespace {

constexpr std::string_view kBrackets = "([{";
// Of rates and accelerations, where they end a name.
constexpr std::string_view kUnitsAtEnd =
    "radps rads radpersec degps degs degpersec dps g mg mps2 ms2 mss";

bool isCapital(char letter) {
  return letter >= 'A' && letter <= 'Z';
}

/// Returns the words between blanks and signs, and from a small letter to a capital one.
std::vector<std::string> wordsInName(std::string_view name) {
  constexpr std::string_view kBetween = " _-./:\t";
  std::vector<std::string> words(1);
  char before = ' ';
  for (const char letter : name) {
    const bool isBetween = kBetween.find(letter) != kBetween.npos;
    const bool begins = isCapital(letter) && before >= 'a' && before <= 'z';
    if ((isBetween || begins) && !words.back().empty()) words.emplace_back();
    if (!isBetween) words.back() += smallText({&letter, 1});
    before = letter;
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// Returns the number of words at the end that are a unit.
std::size_t unitWords(const std::vector<std::string>& words) {
  const std::size_t count = words.size();
  if (count > 2 && isAmong(kUnitsAtEnd, words[count - 2] + words[count - 1])) return 2;
  return count > 1 && isAmong(kUnitsAtEnd, words.back()) ? 1 : 0;
}

}  // namespace

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    if (end == text.size()) return words;
    text.remove_prefix(end + 1);
  }
}

std::string smallText(std::string_view text) {
  std::string result(text);
  for (char& letter : result) {
    if (isCapital(letter)) letter = static_cast<char>(letter - 'A' + 'a');
  }
  return result;
}

bool isAmong(std::string_view list, std::string_view word) {
  return std::ranges::count(wordsOf(list), word) > 0;
}

ColumnName columnNameOf(std::string_view header) {
  ColumnName name;
  const std::size_t bracket = std::min(header.find_first_of(kBrackets), header.size());
  name.words = wordsInName(header.substr(0, bracket));
  for (std::size_t i = 0; i + unitWords(name.words) < name.words.size(); ++i)
    name.plain += name.words[i];
  if (bracket == header.size()) return name;
  const std::string_view inside = header.substr(bracket + 1);
  name.unit = smallText(inside.substr(0, inside.find_first_of(")]}")));
  std::erase(name.unit, ' ');
  return name;
}

}  // namespace rotatebook::recording
