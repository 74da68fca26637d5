#include "recording/words.h"

#include <algorithm>

namespace rotatebook::recording {

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    if (end == text.size()) return words;
    text.remove_prefix(end + 1);
  }
}

bool isAmong(std::string_view list, std::string_view word) {
  return std::ranges::count(wordsOf(list), word) > 0;
}

}  // namespace rotatebook::recording
