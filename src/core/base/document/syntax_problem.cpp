#include "base/document/syntax_problem.h"

#include <algorithm>
#include <array>

#include "base/text.h"

namespace rotatebook::document {
namespace {

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kNumberBegins = "0123456789+-.,";

/// A part of a message of toml++, and the text in its place; % is the wrong word.
struct Remedy {
  std::string_view part;
  std::string_view text;
};

constexpr Remedy kRemedies[] = {
    {"redefine", "stated above already; keep one of them, and each section in one piece"},
    {"value type", "% isn't a value; text is in \"quotes\", a list in [brackets]"},
    {"expected '='", "% where = should be: lines are KEY = VALUE, or headers such as [clip]"},
    {"expected value", "a value is missing after ="},
    {"pair: encountered end", "a key needs = VALUE, but the file ends here"},
    {"end-of-file", "the file ends within a value or header; a quote or bracket isn't closed"},
    {"comment or whitespace",
     "% after the end of a value or header; lists are in [brackets], comments begin with #"},
    {"comma or closing", "a comma is missing before %"},
    {"expected ']'", "a header's ] is missing before %"},
    {"utf-8", "the text isn't in UTF-8; save it in UTF-8"},
    {"nested value depth", "lists or tables are nested more than 256 deep"},
    {"digit", "% can't be read as a number; write one such as 0.0167, without a unit or fraction"},
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
  if (rest.starts_with(';')) return "a comma separates values, not a semicolon";
  if (rest.empty() && message.find("control characters") != message.npos) {
    return "a string doesn't end on its line; its closing quote is missing";
  }
  const std::string_view first = rest.substr(0, rest.find_first_of(" \t", 1));
  const std::string word = first.empty()            ? "the end of the line"
                           : first.starts_with('"') ? oneLine(first, 20)
                                                    : quotedBeginning(first, 20);
  const auto remedy = std::ranges::find_if(
      kRemedies, [&](const Remedy& one) { return message.find(one.part) != message.npos; });
  if (remedy == std::end(kRemedies)) {
    // Leave out what the parser was about: "Error while parsing array: "
    const auto about = message.find(": ");
    return word +
           " isn't TOML: " + std::string(message.substr(about == message.npos ? 0 : about + 2));
  }
  std::string problem(remedy->text);
  if (const auto at = problem.find('%'); at != problem.npos) problem.replace(at, 1, word);
  return problem;
}

}  // namespace rotatebook::document
