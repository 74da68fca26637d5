// The words that pictures show, and their translations.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace rotatebook::scene {

/// A word or phrase that pictures show. Each has a row in word_list.inc.
enum class Word {
#define ROTATEBOOK_WORD(enumerator, english, german) enumerator,
#include "scene/word_list.inc"
#undef ROTATEBOOK_WORD
};

/// The words in English, in the order of Word.
inline constexpr std::array kEnglishWords{
#define ROTATEBOOK_WORD(enumerator, english, german) std::string_view(english),
#include "scene/word_list.inc"
#undef ROTATEBOOK_WORD
};

/// The words in German, likewise.
inline constexpr std::array kGermanWords{
#define ROTATEBOOK_WORD(enumerator, english, german) std::string_view(german),
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

inline Words germanWords() {
  return {Words::textsOf(kGermanWords), ","};
}

}  // namespace rotatebook::scene
