// A check that text is JSON (RFC 8259).
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace rotatebook::report::testing {

/// Reads a JSON value from the beginning of a text.
class JsonChecker {
 public:
  explicit JsonChecker(std::string_view text) : text_(text) {}

  /// Returns whether the text is one value, with white space around it.
  bool isOneValue() {
    if (!value()) return false;
    skipSpace();
    return text_.empty();
  }

 private:
  void skipSpace() {
    const std::size_t end = text_.find_first_not_of(" \t\r\n");
    text_.remove_prefix(end == text_.npos ? text_.size() : end);
  }

  bool take(std::string_view expected) {
    skipSpace();
    if (!text_.starts_with(expected)) return false;
    text_.remove_prefix(expected.size());
    return true;
  }

  bool value() {
    if (take("{")) return members();
    if (take("[")) return elements();
    skipSpace();
    if (text_.starts_with('"')) return string();
    return take("null") || take("true") || take("false") || number();
  }

  bool members() {
    if (take("}")) return true;
    do {
      skipSpace();
      if (!string() || !take(":") || !value()) return false;
    } while (take(","));
    return take("}");
  }

  bool elements() {
    if (take("]")) return true;
    do {
      if (!value()) return false;
    } while (take(","));
    return take("]");
  }

  bool string() {
    if (!take("\"")) return false;
    for (;;) {
      if (text_.empty() || static_cast<unsigned char>(text_.front()) < ' ') return false;
      const char character = text_.front();
      text_.remove_prefix(1);
      if (character == '"') return true;
      if (character == '\\' && !escape()) return false;
    }
  }

  bool escape() {
    constexpr std::size_t kDigits = 4;
    const bool isCode = text_.starts_with('u');
    const std::size_t size = isCode ? 1 + kDigits : 1;
    if (text_.size() < size) return false;
    const bool known =
        isCode ? text_.substr(1, kDigits).find_first_not_of("0123456789abcdefABCDEF") == text_.npos
               : std::string_view("\"\\/bfnrt").find(text_.front()) != text_.npos;
    text_.remove_prefix(size);
    return known;
  }

  std::size_t digits() {
    const std::size_t count = std::min(text_.find_first_not_of("0123456789"), text_.size());
    text_.remove_prefix(count);
    return count;
  }

  bool eat(std::string_view any) {
    if (text_.empty() || any.find(text_.front()) == any.npos) return false;
    text_.remove_prefix(1);
    return true;
  }

  bool number() {
    eat("-");
    const bool zero = text_.starts_with('0');
    const std::size_t whole = digits();
    if (whole == 0 || (zero && whole > 1)) return false;
    if (eat(".") && digits() == 0) return false;
    if (!eat("eE")) return true;
    eat("+-");
    return digits() > 0;
  }

  std::string_view text_;
};

inline bool isOneJsonValue(std::string_view text) {
  return JsonChecker(text).isOneValue();
}

}  // namespace rotatebook::report::testing
