#include "recording/csv_layout.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "base/text.h"
#include "recording/csv_cells.h"
#include "recording/unit_tables.h"
#include "recording/words.h"

namespace rotatebook::recording {
namespace {

/// A line above the first row.
struct HeadLine {
  std::string_view text;  // without the mark that a comment begins with
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

/// Returns whether a line is a row of a table: it has cells, and more numbers than words.
bool isRow(const std::vector<std::string_view>& cells, char separator) {
  if (cells.size() < 2) return false;
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

template <typename Cell>
std::size_t distinctCount(const std::vector<Cell>& cells) {
  return std::set<std::string_view>(cells.begin(), cells.end()).size();
}

/// Puts the cells of the line above before the names, as OptiTrack's "Rotation" and "Position" are
/// above "X", if more names differ then.
void tellApart(CsvLayout& layout, const std::vector<HeadLine>& head, const HeadLine& header) {
  const HeadLine* above = nullptr;
  for (const HeadLine& line : head) {
    if (!line.isComment && line.number < header.number) above = &line;
  }
  if (above == nullptr) return;
  const auto groups = cellsOf(above->text, layout.separator);
  if (groups.size() != layout.header.size()) return;
  std::vector<std::string> names = layout.header;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!groups[i].empty()) names[i] = utf8FromLatin1(groups[i]) + ' ' + names[i];
  }
  if (distinctCount(names) > distinctCount(layout.header)) layout.header = std::move(names);
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

/// Returns the line that names the cells of `row`, of several that with most different names, the
/// first, or else the last comment; null if none does.
const HeadLine* headerAmong(const std::vector<HeadLine>& head,
                            const std::vector<std::string_view>& row, char separator) {
  const HeadLine *plain = nullptr, *comment = nullptr;
  std::size_t most = 0;
  for (const HeadLine& line : head) {
    if (!names(line, row, separator)) continue;
    if (line.isComment) {
      comment = &line;
      continue;
    }
    const std::size_t count = distinctCount(cellsOf(line.text, separator));
    if (count > most) plain = &line;
    most = std::max(most, count);
  }
  return plain != nullptr ? plain : comment;
}

/// Returns the length of the mark that a comment begins with; 0 of other lines. ROS's "%time" is a
/// name.
std::size_t commentMark(std::string_view line) {
  if (line.starts_with("//")) return 2;
  return line.starts_with('#') || line.starts_with("% ") ? 1 : 0;
}

}  // namespace

bool isComment(std::string_view line) {
  return commentMark(trimmed(line)) > 0;
}

CsvLayout layoutOf(std::string_view text) {
  constexpr std::size_t kMaxUnnamed = 4;  // Rows above the header, as of a cut line.
  CsvLayout layout;
  std::optional<char> stated;
  std::vector<HeadLine> head;
  std::size_t number = 0, unnamed = 0, firstLine = 0;
  std::string_view first;  // From the first row on.
  char firstSeparator = ',';
  while (!text.empty() && unnamed < kMaxUnnamed) {
    const std::string_view whole = text, line = takeLine(text), plain = trimmed(line);
    ++number;
    if (plain.empty()) continue;
    if (head.empty() && !stated) {
      stated = statedSeparator(plain);
      if (stated) continue;
    }
    const std::size_t mark = commentMark(plain);
    layout.separator = stated.value_or(separatorOf(line));
    const std::vector<std::string_view> cells = cellsOf(line, layout.separator);
    if (mark > 0 || !isRow(cells, layout.separator)) {
      head.push_back({mark > 0 ? plain.substr(mark) : line, mark > 0, text, number});
      continue;
    }
    if (const HeadLine* header = headerAmong(head, cells, layout.separator)) {
      takeHeader(layout, *header, cells.size());
      tellApart(layout, head, *header);
      takeUnits(layout, head, *header);
      return layout;
    }
    if (unnamed++ > 0) continue;
    first = whole;
    firstLine = number;
    firstSeparator = layout.separator;
  }
  const auto plain = std::ranges::find_if(head, [&](const HeadLine& line) {
    return !line.isComment && (unnamed == 0 || line.number < firstLine);
  });
  if (plain == head.end()) return {firstSeparator, {}, first, firstLine};
  layout.separator = stated.value_or(separatorOf(plain->text));
  takeHeader(layout, *plain, cellsOf(plain->text, layout.separator).size());
  return layout;
}

}  // namespace rotatebook::recording
