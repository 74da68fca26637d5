// The words that pictures show, and their translations.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/document/value_reader.h"

namespace rotatebook::scene {

/// A word or phrase that pictures show. Each has a row in word_list.inc.
enum class Word {
#define ROTATEBOOK_WORD(enumerator, english) enumerator,
#include "scene/word_list.inc"
#undef ROTATEBOOK_WORD
};

/// The words in English, in the order of Word.
inline constexpr std::array kEnglishWords{
#define ROTATEBOOK_WORD(enumerator, english) std::string_view(english),
#include "scene/word_list.inc"
#undef ROTATEBOOK_WORD
};

/// The words of pictures in one language; English by default.
struct Words {
  std::array<std::string, kEnglishWords.size()> texts = textsOf(kEnglishWords);
  std::string decimalMark = ".";

  const std::string& operator[](Word word) const { return texts[static_cast<std::size_t>(word)]; }
  /// Returns the word that is `english` in English; `english` itself if there is none.
  std::string of(std::string_view english) const {
    const auto found = std::find(kEnglishWords.begin(), kEnglishWords.end(), english);
    if (found == kEnglishWords.end()) return std::string(english);
    return texts[static_cast<std::size_t>(found - kEnglishWords.begin())];
  }
  /// Returns `text`, a number and perhaps its unit, with the decimal mark.
  std::string number(std::string text) const {
    if (const auto point = text.find('.'); point != text.npos) text.replace(point, 1, decimalMark);
    return text;
  }

  static std::array<std::string, kEnglishWords.size()> textsOf(
      const std::array<std::string_view, kEnglishWords.size()>& words) {
    std::array<std::string, kEnglishWords.size()> texts;
    for (std::size_t i = 0; i < words.size(); ++i) texts[i] = words[i];
    return texts;
  }
  friend bool operator==(const Words&, const Words&) = default;
};

/// The languages that ship.
inline constexpr std::array<std::string_view, 2> kLanguages{"english", "german"};

/// Returns the German words of assets/words/german.toml.
Words germanWords();

/// Reads the words and the decimal mark of a table, by their English; those that it lacks are
/// English. A list of words has tables for the page, too (page/language.h), which are left to it.
Words readWords(const document::ValueReader& table);

}  // namespace rotatebook::scene
