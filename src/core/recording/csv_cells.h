// Lines and cells of a table of text. Inside the room only.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "recording/decimal.h"

namespace rotatebook::recording {

/// Kinds of cells.
enum class CellKind {
  Number,  ///< Finite.
  Hole,    ///< Empty, or one of the words that programs write where there is no reading: NaN.
  Text,
};

/// Takes the first line off `rest`, without its end.
std::string_view takeLine(std::string_view& rest);

/// Returns what separates the cells of a line: the first of tab, semicolon, comma, bar and blank
/// that it has.
char separatorOf(std::string_view line);

/// Cells of a line that are taken; more are too many for any table.
inline constexpr std::size_t kMaxCells = 1024;

/// Returns the first kMaxCells cells of a line, without blanks and quotation marks around them.
/// Between quotation marks nothing separates; several blanks in a row separate once.
std::vector<std::string_view> cellsOf(std::string_view line, char separator);

/// Returns the finite number that a cell has; nothing if it has none. Where commas don't separate,
/// they may be decimal; a minus may be U+2212, and an exponent begin with Fortran's D.
std::optional<double> numberIn(std::string_view cell, char separator);

/// Returns the number that a cell has, all digits of its whole part; nothing if it has none, or one
/// of more than 63 bits.
std::optional<Decimal> decimalIn(std::string_view cell, char separator);

CellKind kindOf(std::string_view cell, char separator);

}  // namespace rotatebook::recording
