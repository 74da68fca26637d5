#include "recording/csv_table.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::recording {
namespace {

constexpr std::size_t kLongestNumber = 64;  // [bytes]
constexpr std::size_t kLongestShown = 40;   // of a cell in messages [characters]

char separatorOf(std::string_view header) {
  for (const char separator : {'\t', ';'}) {
    if (header.find(separator) != header.npos) return separator;
  }
  return ',';
}

std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  const bool isQuoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return isQuoted ? cell.substr(1, cell.size() - 2) : cell;
}

/// Takes the first cell off `rest`, up to a separator that isn't between quotation marks.
std::string_view takeCell(std::string_view& rest, char separator, bool& isLast) {
  bool isQuoted = false;
  std::size_t end = 0;
  for (; end < rest.size() && (isQuoted || rest[end] != separator); ++end) {
    if (rest[end] == '"') isQuoted = !isQuoted;
  }
  const std::string_view cell = unquoted(rest.substr(0, end));
  isLast = end == rest.size();
  rest.remove_prefix(isLast ? end : end + 1);
  return cell;
}

/// Calls `take` with each cell of a line.
template <typename Take>
void forEachCell(std::string_view line, char separator, const Take& take) {
  for (bool isLast = false; !isLast;) take(takeCell(line, separator, isLast));
}

std::string_view takeLine(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
  const std::string_view line = rest.substr(0, end);
  const bool isPair = rest.substr(end, 2) == "\r\n";
  rest.remove_prefix(std::min(rest.size(), end + (isPair ? 2 : 1)));
  return line;
}

}  // namespace

CsvTable::CsvTable(std::string_view bytes, std::string name) : name_(std::move(name)) {
  if (bytes.size() > kLargestRecording) {
    fail("longer than " + std::to_string(kLargestRecording >> 20) +
         " MiB, the limit for a recording; export a part of it");
  }
  bytes = withoutByteOrderMark(bytes);
  for (std::size_t number = 1; !bytes.empty(); ++number) {
    const std::string_view line = takeLine(bytes);
    if (trimmed(line).empty() || line.front() == '#') continue;
    if (!header_.empty()) {
      addRow(line, number);
      continue;
    }
    separator_ = separatorOf(line);
    forEachCell(line, separator_, [this](std::string_view cell) {
      header_.emplace_back(cell);
      if (header_.size() > kMaxColumns)
        fail("more than " + std::to_string(kMaxColumns) + " columns");
    });
  }
  if (lines_.empty()) fail("no rows below a header; a recording is a table of numbers (CSV)");
}

void CsvTable::addRow(std::string_view line, std::size_t number) {
  if (lines_.size() == kMaxRows) {
    fail("more than " + std::to_string(kMaxRows) + " rows; export a part of it");
  }
  std::size_t count = 0;
  lines_.push_back(number);
  forEachCell(line, separator_, [&](std::string_view cell) {
    if (++count <= header_.size()) cells_.push_back(cell);
  });
  if (count == header_.size()) return;
  failAt(lines_.size() - 1, std::to_string(count) + (count == 1 ? " cell" : " cells") +
                                ", but the header names " + std::to_string(header_.size()) +
                                " columns");
}

double CsvTable::at(std::size_t row, std::size_t column) const {
  const std::string_view cell = cells_[row * header_.size() + column];
  std::string text(cell.substr(cell.starts_with('+') ? 1 : 0, kLongestNumber));
  if (separator_ != ',') {
    if (const std::size_t comma = text.find(','); comma != text.npos) text[comma] = '.';
  }
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && rest == end && std::isfinite(value)) return value;
  failAt(row, "the column " + quotedText(oneLine(header_[column], kLongestShown)) + " has " +
                  quotedText(oneLine(cell, kLongestShown)) +
                  ", which is no finite number; leave such rows out");
}

void CsvTable::failAt(std::size_t row, const std::string& problem) const {
  throw InputError(name_ + ":" + std::to_string(lines_[row]) + ": " + problem);
}

void CsvTable::fail(const std::string& problem) const {
  throw InputError(name_ + ": " + problem);
}

}  // namespace rotatebook::recording
