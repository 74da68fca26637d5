#include "recording/csv_cells.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include "base/parsed_number.h"
#include "base/text.h"
#include "recording/words.h"

namespace rotatebook::recording {
namespace {

constexpr std::size_t kLongestNumber = 64;  // [bytes]

std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  const bool isQuoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return isQuoted ? cell.substr(1, cell.size() - 2) : cell;
}

/// Returns a number as from_chars reads it: with a point, the usual minus, and an "e" in the place
/// of Fortran's "d".
std::string plainNumber(std::string_view cell, char separator) {
  constexpr std::string_view kMinus = "\xE2\x88\x92";
  std::string text(cell.substr(cell.starts_with('+') ? 1 : 0, kLongestNumber));
  if (text.starts_with(kMinus)) text.replace(0, kMinus.size(), "-");
  if (separator != ',') {
    if (const std::size_t comma = text.find(','); comma != text.npos) text[comma] = '.';
  }
  const std::size_t power = text.find_first_of("dD");
  const bool isFortran = power != text.npos && power > 0 && text[power - 1] <= '9';
  if (isFortran) text[power] = 'e';
  return text;
}

bool separates(char letter, char separator) {
  return letter == separator || (separator == ' ' && letter == '\t');
}

/// Takes the first cell off `rest`, up to a separator that isn't between quotation marks.
std::string_view takeCell(std::string_view& rest, char separator, bool& isLast) {
  bool isQuoted = false;
  std::size_t end = 0;
  for (; end < rest.size() && (isQuoted || !separates(rest[end], separator)); ++end) {
    if (rest[end] == '"') isQuoted = !isQuoted;
  }
  const std::string_view cell = unquoted(rest.substr(0, end));
  isLast = end == rest.size();
  rest.remove_prefix(isLast ? end : end + 1);
  if (separator == ' ') rest = trimmed(rest);
  return cell;
}

}  // namespace

std::string_view takeLine(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
  const std::string_view line = rest.substr(0, end);
  const bool isPair = rest.substr(end, 2) == "\r\n";
  rest.remove_prefix(std::min(rest.size(), end + (isPair ? 2 : 1)));
  return line;
}

char separatorOf(std::string_view line) {
  for (const char separator : {'\t', ';', ',', '|'}) {
    if (line.find(separator) != line.npos) return separator;
  }
  return ' ';
}

std::vector<std::string_view> cellsOf(std::string_view line, char separator) {
  if (separator == ' ') line = trimmed(line);
  std::vector<std::string_view> cells;
  for (bool isLast = false; !isLast && cells.size() < kMaxCells;)
    cells.push_back(takeCell(line, separator, isLast));
  return cells;
}

std::optional<double> numberIn(std::string_view cell, char separator) {
  const auto value = parsedNumber<double>(plainNumber(cell, separator));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<Decimal> decimalIn(std::string_view cell, char separator) {
  if (!numberIn(cell, separator)) return std::nullopt;
  const std::string plain = plainNumber(cell, separator);
  cell = plain;
  const std::size_t end = std::min(cell.find_first_of("eE"), cell.size());
  std::string digits = "0";
  std::size_t fraction = 0;  // digits behind the point
  bool isBehind = false;
  for (const char letter : cell.substr(0, end)) {
    const bool isDigit = letter >= '0' && letter <= '9';
    if (isDigit) digits += letter;
    if (isDigit && isBehind) ++fraction;
    isBehind |= letter == '.' || letter == ',';
  }
  int exponent = 0;
  std::string_view power = cell.substr(std::min(end + 1, cell.size()));
  if (power.starts_with('+')) power.remove_prefix(1);
  std::from_chars(power.data(), power.data() + power.size(), exponent);
  constexpr int kMost = 400;  // A number of more is infinite, or 0.
  exponent = std::clamp(exponent, -kMost, kMost) - static_cast<int>(fraction);
  if (exponent > 0) digits.append(static_cast<std::size_t>(exponent), '0');
  const auto behind = static_cast<std::size_t>(std::max(-exponent, 0));
  if (behind >= digits.size()) digits.insert(0, behind + 1 - digits.size(), '0');
  const char* const point = digits.data() + digits.size() - behind;
  Decimal number;
  if (std::from_chars(digits.data(), point, number.whole).ec != std::errc()) return std::nullopt;
  const std::string rest = "0." + digits.substr(digits.size() - behind) + "0";
  std::from_chars(rest.data(), rest.data() + rest.size(), number.rest);
  return cell.starts_with('-') ? Decimal{-number.whole, -number.rest} : number;
}

CellKind kindOf(std::string_view cell, char separator) {
  if (numberIn(cell, separator)) return CellKind::Number;
  // As programs write what isn't there: C's and Windows's, Excel's, R's and Python's.
  constexpr std::string_view kHoles =
      "nan -nan nan(ind) -nan(ind) nan(snan) 1.#qnan -1.#qnan 1.#ind -1.#ind #n/a #num! #div/0! "
      "#value! null na n/a <na> none - --";
  const bool isHole = cell.empty() || isAmong(kHoles, lowerCase(cell));
  return isHole ? CellKind::Hole : CellKind::Text;
}

}  // namespace rotatebook::recording
