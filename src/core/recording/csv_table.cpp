#include "recording/csv_table.h"

#include <utility>

#include "base/error.h"
#include "base/file_text.h"
#include "base/text.h"
#include "recording/csv_cells.h"
#include "recording/csv_layout.h"

namespace rotatebook::recording {
namespace {

constexpr std::size_t kLongestShown = 40;  // of a cell in messages [characters]

/// A kind of file that isn't read, by its first bytes.
struct Foreign {
  std::string_view beginning, problem;
};

constexpr std::string_view kUtf32 = "its text is in UTF-32; save it as UTF-8 (\"CSV UTF-8\")";
constexpr Foreign kForeign[]{
    {"\xD0\xCF\x11\xE0",
     "a workbook (.xls), which isn't read; export the recording as CSV, of phyphox's formats "
     "\"CSV (Comma, decimal point)\""},
    {"PK\x03\x04",
     "a ZIP archive or a workbook (.xlsx), but a table of text is read here; unpack "
     "it and name the table, or save the workbook as CSV"},
    {"\x1F\x8B", "compressed by gzip; unpack it"},
    {"version https://git-lfs",
     "a pointer of git-lfs in the place of the table; fetch that with \"git lfs pull\""},
    {"<!DOCTYPE", "a web page; download the table that it shows"},
    {"<html", "a web page; download the table that it shows"},
    {"{", "JSON, which isn't read; export the recording as CSV"},
    {"[{", "JSON, which isn't read; export the recording as CSV"},
    {std::string_view("\xFF\xFE\0\0", 4), kUtf32},
    {std::string_view("\0\0\xFE\xFF", 4), kUtf32},
};

/// Returns whether a cell has numbers before and behind `sign`, as times of day and dates have.
bool joins(std::string_view cell, char sign) {
  const auto isDigit = [&](std::size_t i) {
    return i < cell.size() && cell[i] >= '0' && cell[i] <= '9';
  };
  const std::size_t at = cell.find(sign);
  return at != cell.npos && at > 0 && isDigit(at - 1) && isDigit(at + 1);
}

/// Returns what a cell is that is no number.
std::string_view kindText(std::string_view cell) {
  const bool isDate = joins(cell, '-') || joins(cell, '/');
  if (joins(cell, ':')) return isDate ? "a date with a time of day" : "a time of day";
  return isDate ? "a date" : "no finite number";
}

std::string cellsText(std::size_t count) {
  const char* const more = count == kMaxCells ? " or more" : "";
  return std::to_string(count) + more + (count == 1 ? " cell" : " cells");
}

}  // namespace

CsvTable::CsvTable(std::string_view bytes, std::string name) : name_(std::move(name)) {
  if (bytes.size() > kLargestRecording) {
    fail("longer than " + std::to_string(kLargestRecording >> 20) +
         " MiB, the limit for a recording; export a part of it");
  }
  requireText(bytes);
  CsvLayout layout = layoutOf(textOfFile(bytes, decoded_));
  separator_ = layout.separator;
  header_ = std::move(layout.header);
  if (header_.size() > kMaxColumns) fail("more than " + std::to_string(kMaxColumns) + " columns");
  if (header_.empty() && layout.line > 0) {
    throw InputError(name_ + ":" + std::to_string(layout.line) +
                     ": a row of numbers, but no line above it names its columns; add one, such as "
                     "\"time_s,wx,wy,wz\"");
  }
  for (std::size_t number = layout.line; !layout.rows.empty(); ++number) {
    const std::string_view line = takeLine(layout.rows);
    if (!trimmed(line).empty() && !isComment(line)) addRow(line, number);
  }
  if (firstShort_ == 0 && !lines_.empty()) failShort("give each column a cell in every row");
  if (lines_.empty()) fail("no rows below a header; a recording is a table of numbers (CSV)");
}

void CsvTable::requireText(std::string_view bytes) const {
  for (const Foreign& kind : kForeign) {
    if (bytes.starts_with(kind.beginning)) fail(std::string(kind.problem));
  }
  const std::string_view first = bytes.substr(0, 4), three("\0\0\0", 3);
  if (first.size() == 4 && first.ends_with(three) != first.starts_with(three))
    fail(std::string(kUtf32));
  if (bytes.size() > 1 && (bytes[0] == '\0') != (bytes[1] == '\0')) {
    fail("its text is in UTF-16 without its byte order mark; save it as UTF-8 (\"CSV UTF-8\")");
  }
}

void CsvTable::addRow(std::string_view line, std::size_t number) {
  if (lines_.size() == kMaxRows) {
    fail("more than " + std::to_string(kMaxRows) + " rows; export a part of it");
  }
  lines_.push_back(number);
  std::vector<std::string_view> cells = cellsOf(line, separator_);
  while (cells.size() > header_.size() && cells.back().empty()) cells.pop_back();
  const bool isShort = cells.size() < header_.size();
  if (firstShort_ && !isShort) failShort("leave such rows out");
  if (cells.size() > header_.size()) {
    failAt(lines_.size() - 1, cellsText(cells.size()) + namedText() +
                                  "; name them all, or, if numbers have decimal commas, separate "
                                  "the cells by semicolons");
  }
  if (isShort && !firstShort_) {
    firstShort_ = lines_.size() - 1;
    cellsOfShort_ = cells.size();
  }
  cells.resize(header_.size());
  cells_.insert(cells_.end(), cells.begin(), cells.end());
}

std::string CsvTable::namedText() const {
  return ", but the header names " + countText(std::ssize(header_), "column");
}

void CsvTable::failShort(const std::string& remedy) const {
  failAt(*firstShort_, cellsText(cellsOfShort_) + namedText() + "; " + remedy);
}

bool CsvTable::isHole(std::size_t row, std::size_t column) const {
  return kindOf(cells_[row * header_.size() + column], separator_) == CellKind::Hole;
}

bool CsvTable::isText(std::size_t row, std::size_t column) const {
  return kindOf(cells_[row * header_.size() + column], separator_) == CellKind::Text;
}

double CsvTable::at(std::size_t row, std::size_t column, const std::string& remedy) const {
  const std::string_view cell = cells_[row * header_.size() + column];
  if (const auto number = numberIn(cell, separator_)) return *number;
  // Commas, blanks, also those that don't break, and apostrophes.
  constexpr std::string_view kDigits = "0123456789", kMarks = ",' \xC2\xA0\xE2\x80\xAF\x99";
  const bool haveMarks =
      !cell.empty() && kDigits.find(cell.back()) != kDigits.npos &&
      cell.find_first_not_of("+-.0123456789,' \xC2\xA0\xE2\x80\xAF\x99") == cell.npos &&
      cell.find_first_of(kMarks) != cell.npos;
  failAt(row,
         "the column " + quotedBeginning(header_[column], kLongestShown) + " has " +
             quotedBeginning(cell, kLongestShown) + ", which is " + std::string(kindText(cell)) +
             "; " +
             (haveMarks ? "write numbers without marks between digits, such as 1000.5" : remedy));
}

std::optional<Decimal> CsvTable::decimalAt(std::size_t row, std::size_t column) const {
  return decimalIn(cells_[row * header_.size() + column], separator_);
}

void CsvTable::failAt(std::size_t row, const std::string& problem) const {
  throw InputError(name_ + ":" + std::to_string(lines_[row]) + ": " + problem);
}

void CsvTable::fail(const std::string& problem) const {
  throw InputError(name_ + ": " + problem);
}

}  // namespace rotatebook::recording
