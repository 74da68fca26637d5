// A table of numbers as text, as instruments and programs export them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/decimal.h"

namespace rotatebook::recording {

/// Largest recording that is read. [bytes]
inline constexpr std::size_t kLargestRecording = 16 << 20;
/// Most rows of a recording.
inline constexpr std::size_t kMaxRows = 1'000'000;
/// Most columns of a recording.
inline constexpr std::size_t kMaxColumns = 256;

/// A table below a line that names its columns, see layoutOf(). Cells are separated by tabs,
/// semicolons, commas, bars or blanks, whichever a line has, in this order; where they aren't
/// separated by commas, numbers may have a decimal comma. Empty lines and comments are skipped, and
/// so are empty cells beyond the header's; rows at the end that have too few are filled with holes.
class CsvTable {
 public:
  /// Takes the bytes of a file, which must outlive the table; `name` is the file's in messages.
  /// Throws InputError "NAME:LINE: PROBLEM" for what is no text in UTF-8, Latin-1, or
  /// UTF-16 with its byte order mark, for a table
  /// without a header or rows, for a row of another number of cells than the header, and for more
  /// than kLargestRecording, kMaxRows or kMaxColumns.
  CsvTable(std::string_view bytes, std::string name);
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  const std::string& name() const { return name_; }
  /// Returns the names of the columns, without quotation marks.
  const std::vector<std::string>& header() const { return header_; }
  /// Returns the number of rows below the header, >= 1.
  std::size_t rows() const { return lines_.size(); }
  /// Returns whether a cell is empty or NaN.
  bool isHole(std::size_t row, std::size_t column) const;
  /// Returns whether a cell has text that is neither a number nor NaN.
  bool isText(std::size_t row, std::size_t column) const;
  /// Returns the finite number in a cell. Throws InputError "NAME:LINE: PROBLEM; REMEDY" if there
  /// is none.
  double at(std::size_t row, std::size_t column,
            const std::string& remedy = "leave such rows out") const;
  /// Returns the finite number in a cell, see decimalIn(); nothing if there is none.
  std::optional<Decimal> decimalAt(std::size_t row, std::size_t column) const;
  /// Throws InputError "NAME:LINE: PROBLEM" with the line of `row`.
  [[noreturn]] void failAt(std::size_t row, const std::string& problem) const;
  /// Throws InputError "NAME: PROBLEM".
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  void requireText(std::string_view bytes) const;
  void addRow(std::string_view line, std::size_t number);
  std::string namedText() const;
  [[noreturn]] void failShort(const std::string& remedy) const;

  std::string name_;
  std::string decoded_;  // UTF-16's text
  char separator_ = ',';
  std::vector<std::string> header_;
  std::vector<std::string_view> cells_;      // row by row
  std::vector<std::size_t> lines_;           // of each row in the file, from 1
  std::optional<std::size_t> firstShort_{};  // Row of too few cells, as at the end of a cut file.
  std::size_t cellsOfShort_ = 0;
};

}  // namespace rotatebook::recording
