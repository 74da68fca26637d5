#include "recording/csv_layout.h"

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "recording/csv_cells.h"
#include "recording/unit_tables.h"
#include "recording/words.h"

namespace rotatebook::recording {
namespace {

/// A line above the first row.
struct HeadLine {
  std::string_view text;  // without the '#' that it may begin with
  bool isComment = false;
  std::string_view rest;  // what follows the line
  std::size_t number = 0;
};

std::string utf8FromLatin1(std::string_view text) {
  if (validUtf8(text) == text) return std::string(text);
  std::string result;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code >= 0x80) result += static_cast<char>(0xC0 | (code >> 6));
    result += code < 0x80 ? letter : static_cast<char>(0x80 | (code & 0x3F));
  }
  return result;
}

/// Returns the separator of a line "sep=;", as Excel writes it.
std::optional<char> statedSeparator(std::string_view line) {
  while (line.starts_with('"')) line.remove_prefix(1);
  constexpr std::string_view kBegin = "sep=";
  if (!line.starts_with(kBegin)) return std::nullopt;
  line.remove_prefix(kBegin.size());
  return line.empty() ? '\t' : line.front();
}

/// Returns whether a line is a row of a table: it has more numbers than words.
bool isRow(const std::vector<std::string_view>& cells, char separator) {
  int balance = 0;
  for (const std::string_view cell : cells) {
    const CellKind kind = kindOf(cell, separator);
    if (kind != CellKind::Hole) balance += kind == CellKind::Number ? 1 : -1;
  }
  return balance > 0;
}

/// Returns the number of cells up to the last that isn't empty.
std::size_t filledCount(const std::vector<std::string_view>& cells) {
  const auto last = std::find_if(cells.rbegin(), cells.rend(),
                                 [](std::string_view cell) { return !cell.empty(); });
  return static_cast<std::size_t>(cells.rend() - last);
}

bool names(const HeadLine& line, const std::vector<std::string_view>& row, char separator) {
  const auto cells = cellsOf(line.text, separator);
  if (isRow(cells, separator)) return false;
  const std::size_t count = filledCount(cells);
  const auto others = [&](std::string_view cell) {
    return cells.size() - static_cast<std::size_t>(std::ranges::count(cells, cell));
  };
  // A title above the table has a cell alone, a device's name is in each.
  if (2 * others("") <= row.size()) return false;
  if (count > 2 && others(cells.front()) <= cells.size() - count) return false;
  return cells.size() == row.size() || (count <= row.size() && count >= filledCount(row));
}

void takeHeader(CsvLayout& layout, const HeadLine& line, std::size_t cellsOfRow) {
  auto cells = cellsOf(line.text, layout.separator);
  if (cells.size() != cellsOfRow) cells.resize(filledCount(cells));
  for (const std::string_view cell : cells) layout.header.push_back(utf8FromLatin1(cell));
  layout.rows = line.rest;
  layout.line = line.number + 1;
}

/// Returns the unit in a cell, in small letters, without brackets and Shimmer's sign of a usual
/// calibration; empty if it isn't one that is known.
std::string unitIn(std::string_view cell) {
  std::string unit = lowerCase(cell);
  std::erase(unit, ' ');
  if (unit.ends_with('*')) unit.pop_back();
  const bool isBracketed = unit.size() > 2 && (unit.front() == '(' || unit.front() == '[');
  if (isBracketed) unit = unit.substr(1, unit.size() - 2);
  const bool isKnown = unitNamed(kUnitsOfTimes, unit) || unitNamed(kUnitsOfRates, unit) ||
                       unitNamed(kUnitsOfAccelerations, unit);
  return isKnown ? unit : "";
}

/// Puts what a line below the header says of the columns behind their names: units in brackets, and
/// whether they are calibrated. Returns false if it says neither.
bool takeFacts(CsvLayout& layout, const std::vector<std::string_view>& cells) {
  bool isTaken = false;
  for (std::size_t i = 0; i < std::min(cells.size(), layout.header.size()); ++i) {
    std::string& name = layout.header[i];
    const std::string unit = unitIn(cells[i]);
    const bool isKind = cells[i] == "CAL" || cells[i] == "RAW";
    isTaken |= isKind || !unit.empty();
    if (isKind) name += " " + std::string(cells[i]);
    if (!unit.empty() && name.find_first_of("([") == name.npos) name += " (" + unit + ")";
  }
  return isTaken;
}

/// Takes the lines below the header that state units, as Shimmer's programs write them.
void takeUnits(CsvLayout& layout, const std::vector<HeadLine>& head, const HeadLine& header) {
  for (const HeadLine& line : head) {
    if (line.isComment || line.number <= header.number) continue;
    if (!takeFacts(layout, cellsOf(line.text, layout.separator))) return;
    layout.rows = line.rest;
    layout.line = line.number + 1;
  }
}

/// Returns the line that names the cells of `row`; null if none does.
const HeadLine* headerAmong(const std::vector<HeadLine>& head,
                            const std::vector<std::string_view>& row, char separator) {
  const auto isNaming = [&](const HeadLine& line) { return names(line, row, separator); };
  const auto plain = std::ranges::find_if(
      head, [&](const HeadLine& line) { return !line.isComment && isNaming(line); });
  if (plain != head.end()) return &*plain;
  const auto last = std::find_if(head.rbegin(), head.rend(), isNaming);
  return last != head.rend() ? &*last : nullptr;
}

}  // namespace

CsvLayout layoutOf(std::string_view text) {
  CsvLayout layout;
  std::optional<char> stated;
  std::vector<HeadLine> head;
  std::vector<std::string_view> row;
  std::size_t number = 0, rowsLine = 0;
  std::string_view rows;
  while (!text.empty() && row.empty()) {
    const std::string_view whole = text, line = takeLine(text), plain = trimmed(line);
    ++number;
    if (plain.empty()) continue;
    if (head.empty() && !stated) {
      stated = statedSeparator(plain);
      if (stated) continue;
    }
    const bool isComment = plain.front() == '#';
    layout.separator = stated.value_or(separatorOf(line));
    std::vector<std::string_view> cells = cellsOf(line, layout.separator);
    if (!isComment && isRow(cells, layout.separator)) {
      row = std::move(cells);
      rows = whole;
      rowsLine = number;
    } else {
      head.push_back({isComment ? plain.substr(1) : line, isComment, text, number});
    }
  }
  const HeadLine* header = row.empty() ? nullptr : headerAmong(head, row, layout.separator);
  if (header == nullptr) {
    const auto plain = std::ranges::find(head, false, &HeadLine::isComment);
    if (plain == head.end()) return {layout.separator, {}, rows, rowsLine};
    layout.separator = stated.value_or(separatorOf(plain->text));
    takeHeader(layout, *plain, cellsOf(plain->text, layout.separator).size());
    return layout;
  }
  takeHeader(layout, *header, row.size());
  takeUnits(layout, head, *header);
  return layout;
}

}  // namespace rotatebook::recording
