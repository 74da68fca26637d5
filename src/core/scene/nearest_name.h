// What somebody who misspelt a name probably meant.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rotatebook::scene {

/// The candidate that `word` is most likely a misspelling of, none if all of them are too
/// different. Upper and lower case count as equal; a slip is a letter added, left out, changed, or
/// swapped with its neighbour.
std::optional<std::string_view> nearestName(std::string_view word,
                                            std::span<const std::string_view> candidates);

/// `; did you mean "NEAREST"?`, to end a message with; empty if no candidate is near.
std::string didYouMean(std::string_view word, std::span<const std::string_view> candidates);

/// `"a", "b" and "c"`, with the given word before the last.
std::string quotedList(std::span<const std::string_view> names, std::string_view lastWord);

}  // namespace rotatebook::scene
