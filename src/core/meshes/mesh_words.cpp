#include "meshes/mesh_words.h"

#include <algorithm>

#include "base/error.h"
#include "base/parsed_number.h"
#include "base/text.h"

namespace rotatebook::meshes {
namespace {

constexpr std::string_view kBlanks = " \t\v\f", kLineEnds = "\r\n", kNoWord = " \t\v\f\r\n";

template <typename Number>
std::optional<Number> parsed(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  return parsedNumber<Number>(word);
}

}  // namespace

std::optional<double> numberIn(std::string_view word) {
  return parsed<double>(word);
}

std::optional<std::int64_t> integerIn(std::string_view word) {
  return parsed<std::int64_t>(word);
}

void refuseUtf16(std::string_view text) {
  bool isWide = text.size() >= 4;  // every second byte is 0
  for (std::size_t i = 1; isWide && i < 4; ++i) isWide = (text[i] == '\0') != (text[i - 1] == '\0');
  if (isWide) {
    throw InputError("it is a text in UTF-16 without its byte order mark; save it in UTF-8");
  }
}

std::string_view withoutPadding(std::string_view text) {
  // Blanks count, as they hold the last line's end
  constexpr std::string_view kEnds("\0\x1a", 2);
  return text.substr(0, text.find_first_of(kEnds, text.find_last_not_of(kPadding) + 1));
}

void MeshWords::takeLineEnd() {
  rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
  ++line_;
}

/// Skips blanks, and line ends behind backslashes.
void MeshWords::skipBlanks() {
  const auto blanksAfter = [this](std::size_t begin) {
    return std::min(rest_.find_first_not_of(kBlanks, begin), rest_.size());
  };
  rest_.remove_prefix(blanksAfter(0));
  while (isWavefront_ && rest_.starts_with('\\')) {
    const std::size_t end = blanksAfter(1);
    if (end == rest_.size() || kLineEnds.find(rest_[end]) == std::string_view::npos) return;
    rest_.remove_prefix(end);
    takeLineEnd();
    rest_.remove_prefix(blanksAfter(0));
  }
}

std::string_view MeshWords::word() {
  skipBlanks();
  std::string_view found = rest_.substr(0, rest_.find_first_of(kNoWord));
  if (isWavefront_) {
    found = found.substr(0, found.find('#'));
    if (found.size() > 1 && found.ends_with('\\')) found.remove_suffix(1);
  }
  rest_.remove_prefix(found.size());
  return found;
}

std::string_view MeshWords::restOfLine() {
  const std::string_view line = rest_.substr(0, rest_.find_first_of(kLineEnds));
  rest_.remove_prefix(line.size());
  return trimmed(line);
}

bool MeshWords::nextLine() {
  for (;;) {
    const std::string_view line = rest_.substr(0, rest_.find_first_of(kLineEnds));
    rest_.remove_prefix(line.size());
    if (rest_.empty()) return false;
    takeLineEnd();
    const bool goesOn = isWavefront_ && line.ends_with('\\') && line.find('#') == line.npos;
    if (!goesOn) return true;
  }
}

std::string_view MeshWords::wordOnAnyLine() {
  std::string_view found = word();
  while (found.empty() && nextLine()) found = word();
  return found;
}

std::string noNumber(std::string_view word) {
  if (word.empty()) return " is missing";
  return " must be a number, not " + quotedBeginning(word, 40) +
         (word.find(',') != word.npos ? "; write decimal points" : "");
}

double MeshWords::number(const char* what) {
  const std::string_view found = word();
  if (const auto value = numberIn(found)) return *value;
  fail(what + noNumber(found));
}

std::int64_t MeshWords::integer(const char* what) {
  const std::string_view found = word();
  if (const auto value = integerIn(found)) return *value;
  fail(std::string(what) + (found.empty()
                                ? " is missing"
                                : " must be a whole number, not " + quotedBeginning(found, 40)));
}

void MeshWords::fail(const std::string& message) const {
  throw InputError("line " + std::to_string(line_) + ": " + message);
}

std::string_view MeshBytes::take(std::size_t count) {
  if (count > left()) {
    throw InputError("the file ends at byte " + std::to_string(before_ + bytes_.size()) +
                     ", within its data; is it whole?");
  }
  at_ += count;
  return bytes_.substr(at_ - count, count);
}

}  // namespace rotatebook::meshes
