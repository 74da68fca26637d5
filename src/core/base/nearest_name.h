// Suggestions for misspelt names, by edit distance, and for other words of the same meaning.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rotatebook {

/// Returns the candidate that `word` means in other words, such as "degrees", that alone begins
/// with it, or else that it most likely misspells; none if all are too different. Upper and lower
/// case count as equal; an edit is a letter added, left out, changed, or swapped with its
/// neighbour.
std::optional<std::string_view> nearestName(std::string_view word,
                                            std::span<const std::string_view> candidates);

/// Returns `; did you mean "NEAREST"?`, to end a message with; empty if no candidate is near.
std::string didYouMean(std::string_view word, std::span<const std::string_view> candidates);

/// Returns `"a", "b" and "c"`, with `lastWord` before the last name.
std::string quotedList(std::span<const std::string_view> names, std::string_view lastWord);

}  // namespace rotatebook
