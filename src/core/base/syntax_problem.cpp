#include "base/syntax_problem.h"

#include <algorithm>
#include <array>

#include "base/text.h"

namespace rotatebook {
namespace {

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kNumberBegins = "0123456789+-.,";

/// A part of a message of toml++, and what is said in its place; % is the wrong word.
struct Remedy {
  std::string_view part;
  std::string_view text;
};

constexpr Remedy kRemedies[] = {
    {"utf-8", "not UTF-8; save the file as UTF-8"},
    {"end-of-file", "the file ends within a value"},
    {"redefine", "stated above already; keep one of them, and each section in one piece"},
    {"value type", "% isn't a value; text is in \"quotes\", a list in [brackets]"},
    {"expected 'true'", "% isn't a value; true is written in small letters"},
    {"expected 'false'", "% isn't a value; false is written in small letters"},
    {"expected '='", "% where = should be: lines are KEY = VALUE, or headers such as [clip]"},
    {"expected value", "a value is missing after ="},
    {"comment or whitespace",
     "% after the end of a value or header; lists are in [brackets], comments begin with #"},
    {"closing ']'", "a comma or the closing ] is missing before %"},
    {"closing '}'", "a comma or the closing } is missing before %"},
    {"expected ']'", "a header's closing ] is missing before %"},
    {"leading zero", "a number can't begin with a needless zero"},
    {"could not be interpreted", "a number beyond the range of numbers"},
    {"nested value depth", "values are nested too deep"},
    {"blank", "a header needs a name"},
    {"expected keys", "% where a key or header should begin"},
    {"64 bits", "too great an integer"},
    {"decimal digit", "a number needs a digit on each side of its point"},
    {"expected digit", "% isn't part of a number; units aren't written"},
    {"escape sequence", "an unknown escape; a backslash in quotes is written \\\\"},
    {"control characters", "a control character; in quotes, write it as an escape: \\u001B"},
};

/// Returns that line, from 1, without its end.
std::string_view lineOf(std::string_view text, std::size_t line) {
  while (--line > 0 && text.find('\n') != text.npos) text.remove_prefix(text.find('\n') + 1);
  return text.substr(0, std::min(text.find('\n'), text.find('\r')));
}

bool beginsWithCurlyQuote(std::string_view text) {
  constexpr std::array<std::string_view, 9> kQuotes{"“", "”", "„", "‟", "‘", "’", "‚", "«", "»"};
  return std::ranges::any_of(kQuotes, [&](auto quote) { return text.starts_with(quote); });
}

/// Returns whether there is a curly quote where the problem is, or, if a string doesn't end, before
/// it.
bool isOfCurlyQuotes(std::string_view before, std::string_view rest) {
  if (!rest.empty()) return beginsWithCurlyQuote(rest);
  while (!before.empty() && !beginsWithCurlyQuote(before)) before.remove_prefix(1);
  return !before.empty();
}

/// Returns the number with a decimal comma that ends `before`, and that `rest` continues or that
/// another number follows; empty if there is none.
std::string_view commaNumber(std::string_view before, std::string_view rest) {
  if (rest.empty() || kNumberBegins.find(rest.front()) == rest.npos) return {};
  const std::string_view line(before.data(), before.size() + rest.size());
  std::size_t end = before.find_last_not_of(' ') + 1;
  if (rest.front() == ',') end += std::min(rest.find_first_not_of(kDigits, 1), rest.size());
  if (end == 0 || line.substr(end).starts_with(',')) return {};
  const std::size_t begin = line.find_last_not_of("0123456789,", end - 1) + 1;
  const std::string_view number = line.substr(begin, end - begin);
  const bool isOne =
      std::ranges::count(number, ',') == 1 && number.front() != ',' && number.back() != ',';
  return isOne ? number : std::string_view();
}

}  // namespace

std::string syntaxProblem(std::string_view text, std::size_t line, std::size_t column,
                          std::string_view message) {
  const std::string_view whole = lineOf(text, line);
  const std::string_view before = firstCharacters(whole, column - 1);
  const std::string_view rest = whole.substr(before.size());
  if (isOfCurlyQuotes(before, rest)) {
    return "curly quotes, as word processors write them; write straight ones: title = \"Book\"";
  }
  if (const std::string_view number = commaNumber(before, rest); !number.empty()) {
    std::string point(number);
    std::ranges::replace(point, ',', '.');
    return "a comma separates values; write " + std::string(number) + " as " + point +
           " if that is one number";
  }
  if (rest.empty() && message.find("control characters") != message.npos) {
    return "a string doesn't end on its line; its closing quote is missing";
  }
  std::string word = oneLine(rest.substr(0, rest.find_first_of(" \t", 1)), 20);
  if (word.empty())
    word = "the end of the line";
  else if (word.find('"') == word.npos)
    word = '"' + word + '"';
  const auto remedy = std::ranges::find_if(
      kRemedies, [&](const Remedy& one) { return message.find(one.part) != message.npos; });
  if (remedy == std::end(kRemedies)) return word + " isn't TOML: " + std::string(message);
  std::string problem(remedy->text);
  if (const auto at = problem.find('%'); at != problem.npos) problem.replace(at, 1, word);
  return problem;
}

}  // namespace rotatebook
