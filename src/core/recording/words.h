// Words in small letters, and lists of them. Inside the room only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::recording {

/// Returns the words of `text`, which are separated by single blanks.
std::vector<std::string_view> wordsOf(std::string_view text);

/// Returns whether `word` is one of those in `list`, which are separated by blanks.
bool isAmong(std::string_view list, std::string_view word);

}  // namespace rotatebook::recording
