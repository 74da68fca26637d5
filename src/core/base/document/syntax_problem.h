// Describes mistakes in the syntax of a TOML document. Inside the room only.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rotatebook::document {

/// Returns the problem of a text that toml++ refuses with `message` at that line and column, both
/// from 1, with a remedy for frequent mistakes: curly quotes, decimal commas, missing quotes.
std::string syntaxProblem(std::string_view text, std::size_t line, std::size_t column,
                          std::string_view message);

}  // namespace rotatebook::document
