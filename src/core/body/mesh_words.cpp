#include "body/mesh_words.h"

#include <charconv>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::body {
namespace {

constexpr std::string_view kSpaces = " \t\r\v\f";

template <typename Number>
std::optional<Number> parsed(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number number{};
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool isWhole = error == std::errc() && rest == word.data() + word.size();
  return isWhole ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<double> numberIn(std::string_view word) {
  return parsed<double>(word);
}

std::optional<std::int64_t> integerIn(std::string_view word) {
  return parsed<std::int64_t>(word);
}

std::string_view MeshWords::word() {
  const std::size_t begin = rest_.find_first_not_of(kSpaces);
  if (begin == std::string_view::npos || rest_[begin] == '\n') return "";
  rest_.remove_prefix(begin);
  const std::string_view found = rest_.substr(0, rest_.find_first_of(" \t\r\v\f\n"));
  rest_.remove_prefix(found.size());
  return found;
}

std::string_view MeshWords::restOfLine() {
  const std::string_view line = rest_.substr(0, rest_.find('\n'));
  rest_.remove_prefix(line.size());
  return trimmed(line);
}

bool MeshWords::nextLine() {
  const std::size_t end = rest_.find('\n');
  if (end == std::string_view::npos) return false;
  rest_.remove_prefix(end + 1);
  ++line_;
  return true;
}

std::string_view MeshWords::wordOnAnyLine() {
  std::string_view found = word();
  while (found.empty() && nextLine()) found = word();
  return found;
}

double MeshWords::number(const char* what) {
  const std::string_view found = word();
  if (const auto value = numberIn(found)) return *value;
  fail(std::string(what) + (found.empty()
                                ? " is missing"
                                : " must be a number, and is " + quotedText(oneLine(found, 40))));
}

std::int64_t MeshWords::integer(const char* what) {
  const std::string_view found = word();
  if (const auto value = integerIn(found)) return *value;
  fail(std::string(what) +
       (found.empty() ? " is missing"
                      : " must be a whole number, and is " + quotedText(oneLine(found, 40))));
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

}  // namespace rotatebook::body
