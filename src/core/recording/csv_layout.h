// Finds the header and the rows of a table of text. Inside the room only.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::recording {

/// The header of a table, and what follows it.
struct CsvLayout {
  char separator = ',';
  std::vector<std::string> header;  ///< Empty if there is none. In UTF-8.
  std::string_view rows;            ///< The lines below the header.
  std::size_t line = 0;             ///< Number of the first of these lines, from 1.
};

/// Finds the layout of a file's text. A line "sep=;" at its beginning states the separator. The
/// first row is the first line that has more numbers than words, and the header the line above it
/// with as many cells, of several that with most different names, or else the last such comment.
/// Up to three rows above it are skipped. Without one the header is the first line that is no
/// comment; `line` is then that of the first row, too, and the header may not fit it. Lines that
/// have the same in each cell are none. Names that several columns have are told apart by the line
/// above, and units in lines below are put in brackets behind the names, and so is "CAL" or "RAW".
/// Letters of Latin-1 in the header become UTF-8.
CsvLayout layoutOf(std::string_view text);

/// Returns whether a line begins with "#", "//", or "%" and a blank.
bool isComment(std::string_view line);

}  // namespace rotatebook::recording
