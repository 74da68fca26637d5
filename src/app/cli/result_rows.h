// A result as rows, of which the text and the JSON follow. Inside the room only.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"

namespace rotatebook::cli {

/// A number, or another thing that was found: a member of the JSON object, a line of the text, or
/// both.
struct ResultRow {
  std::string_view key{};    ///< Of the member; empty for a line alone.
  Json value{};              ///< Of the member; null if it is unknown.
  std::string_view label{};  ///< Of the line; empty for a sentence.
  std::string text{};        ///< Of the line, with its unit; empty for a member alone.
};

using ResultRows = std::vector<ResultRow>;

/// Prints the lines.
void printRows(const ResultRows& rows, std::ostream& out);

/// Returns the object.
Json jsonOf(const ResultRows& rows);

}  // namespace rotatebook::cli
