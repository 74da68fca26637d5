// Finds values that nest too deeply to be parsed. Inside the room only.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace rotatebook::document {

/// Returns where in a TOML text the first value or table deeper than `deepest` >= 1 begins, if keys
/// with dots and brackets nest so much deeper that a parser that recurses might exhaust the stack;
/// nothing for other texts, be they TOML or not. The root is at depth 0. What is nested within an
/// array of tables by headers counts as less deep than it is. Takes time in proportion to the text.
std::optional<std::size_t> farTooDeep(std::string_view text, int deepest);

}  // namespace rotatebook::document
