#include "scene/words.h"

#include <utility>
#include <vector>

#include "base/text.h"

namespace rotatebook::scene {
namespace {

using document::ValueReader;

using Pair = std::pair<std::string_view, std::string_view>;

/// The first table of assets/words/german.toml.
constexpr std::array kGermanRows{
#include "scene/german_words.inc"
};

/// Doesn't compile if there is none.
consteval std::string_view germanOf(std::string_view english) {
  return std::find_if(kGermanRows.begin(), kGermanRows.end(),
                      [&](const Pair& row) { return row.first == english; })
      ->second;
}

constexpr std::array kGermanWords{
#define ROTATEBOOK_WORD(enumerator, english) germanOf(english),
#include "scene/word_list.inc"
#undef ROTATEBOOK_WORD
};

constexpr std::string_view kDecimalMarkName = "decimal_mark";
/// Point, comma, middle dot and the Arabic mark: with any other, a number would read as another.
constexpr std::array<std::string_view, 4> kDecimalMarks{".", ",", "\u00b7", "\u066b"};
constexpr std::array<std::string_view, 4> kOfThePage{"language", "page", "story", "figures"};
constexpr std::size_t kLongestWord = 60;

std::string decimalMarkFrom(const ValueReader& value) {
  const std::string mark = value.text(kLongestWord);
  if (std::ranges::count(kDecimalMarks, mark) > 0) return mark;
  value.fail(value.name() + " must be " + quotedList(kDecimalMarks, "or") + ", not " +
             describe(value.node()));
}

}  // namespace

Words germanWords() {
  return {Words::textsOf(kGermanWords), std::string(germanOf(kDecimalMarkName))};
}

Words readWords(const ValueReader& table) {
  Words words;
  std::vector<document::Field> fields{{kDecimalMarkName, [&](const ValueReader& mark) {
                                         words.decimalMark = decimalMarkFrom(mark);
                                       }}};
  for (std::size_t i = 0; i < kEnglishWords.size(); ++i) {
    fields.push_back({kEnglishWords[i], [&words, i](const ValueReader& word) {
                        words.texts[i] = word.text(kLongestWord);
                      }});
  }
  for (const std::string_view key : kOfThePage) fields.push_back({key, [](const auto&) {}});
  table.readTable(fields);
  return words;
}

}  // namespace rotatebook::scene
