#include "document/deep_keys.h"

#include <algorithm>
#include <vector>

namespace rotatebook::document {
namespace {

// Depth from which a text is refused before it is parsed. toml++ takes shallower ones in 150 KB of
// the stack of a browser that has 1 MB (measured in V8; 100 KB are too few).
constexpr int kFarTooDeep = 512;
// Brackets in one another of which toml++ takes no more, by TOML_MAX_NESTED_VALUES.
constexpr std::size_t kMaxBrackets = 256;
constexpr std::string_view kEndsWord = " \t\r\n.=#[]{},\"'";

/// Follows a text from key to key, and leaves to the parser what isn't TOML.
class DepthScanner {
 public:
  DepthScanner(std::string_view text, int deepest) : text_(text), deepest_(deepest) {}

  std::optional<std::size_t> find() {
    while (at_ < text_.size() && step()) {
      if (depth_ > kFarTooDeep) return place_;
    }
    return std::nullopt;
  }

 private:
  struct Bracket {
    bool isTable;
    int outside;  // depth of the array or table
    int inside;   // depth from which its keys count, or of its elements
  };

  /// Goes on by a token. Returns false where the parser stops, too.
  bool step() {
    switch (text_[at_]) {
      case '#':
        at_ = std::min(text_.find('\n', at_), text_.size());
        return true;
      case '\n':
        return endLine();
      case '=':
        beginValue();
        return true;
      case '[':
        return isKey_ && brackets_.empty() ? beginHeader() : enter(false);
      case '{':
        return enter(true);
      case ']':
      case '}':
        return close();
      case ',':
        return separate();
      case ' ':
      case '\t':
      case '\r':
      case '.':
        ++at_;
        return true;
      default:
        noteToken();
        return skipToken();
    }
  }

  bool endLine() {
    ++at_;
    if (isHeader_) return false;
    if (!brackets_.empty()) return true;
    depth_ = section_;
    isKey_ = true;
    return true;
  }

  bool beginHeader() {
    if (isHeader_) return false;
    isHeader_ = true;
    isOfArray_ = text_.substr(at_).starts_with("[[");
    headerAt_ = at_;
    at_ += isOfArray_ ? 2 : 1;
    depth_ = 0;
    return true;
  }

  void endHeader() {
    isHeader_ = isKey_ = false;
    section_ = depth_ += isOfArray_ ? 1 : 0;
    at_ += isOfArray_ ? 2 : 1;
  }

  /// The place of a key's last part is that of its value.
  void beginValue() {
    ++at_;
    isKey_ = false;
    isPlaceNext_ = isPlaceOfPart_ && depth_ == deepest_ + 1;
    isPlaceOfPart_ = false;
  }

  bool enter(bool isTable) {
    noteToken();
    if (brackets_.size() == kMaxBrackets) return false;
    brackets_.push_back({isTable, depth_, isTable ? depth_ : depth_ + 1});
    ++at_;
    goInside();
    return true;
  }

  void goInside() {
    const Bracket& bracket = brackets_.back();
    depth_ = bracket.inside;
    isKey_ = bracket.isTable;
    isPlaceNext_ = !place_ && !isKey_ && depth_ > deepest_;
  }

  bool close() {
    if (isHeader_) {
      endHeader();
      return true;
    }
    if (brackets_.empty()) return false;
    depth_ = brackets_.back().outside;
    brackets_.pop_back();
    isKey_ = isPlaceNext_ = false;
    ++at_;
    return true;
  }

  bool separate() {
    if (brackets_.empty()) return false;
    goInside();
    ++at_;
    return true;
  }

  /// Notes a part of a key, or the beginning of a value.
  void noteToken() {
    if (isPlaceNext_) place_ = at_;
    isPlaceNext_ = false;
    if (!isKey_) return;
    ++depth_;
    isPlaceOfPart_ = !place_ && depth_ > deepest_ && !isHeader_;
    if (!place_ && depth_ > deepest_) place_ = isHeader_ ? headerAt_ : at_;
  }

  bool skipToken() {
    const char first = text_[at_];
    if (first == '"' || first == '\'') return skipString(first);
    at_ = std::min(text_.find_first_of(kEndsWord, at_), text_.size());
    return true;
  }

  /// Returns false if the string doesn't end.
  bool skipString(char quote) {
    const bool isLong = text_.substr(at_ + 1).starts_with(quote == '"' ? "\"\"" : "''");
    at_ += isLong ? 3 : 1;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\\' && quote == '"') {
        ++at_;
      } else if (text_[at_] == '\n' && !isLong) {
        return false;
      } else if (text_[at_] == quote && skipQuotes(quote, isLong)) {
        return true;
      }
    }
    return false;
  }

  /// Skips what ends a string here, if it does: up to two quotes before the last three are in it.
  bool skipQuotes(char quote, bool isLong) {
    const std::size_t end = std::min(text_.find_first_not_of(quote, at_), text_.size());
    if (isLong && end - at_ < 3) return false;
    at_ += isLong ? std::min<std::size_t>(end - at_, 5) : 1;
    return true;
  }

  std::string_view text_;
  int deepest_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int section_ = 0;  // depth of the table whose header came last
  std::vector<Bracket> brackets_;
  bool isKey_ = true;  // A key is next, or its next part; else a value.
  bool isHeader_ = false;
  bool isOfArray_ = false;  // [[header]]
  std::size_t headerAt_ = 0;
  std::optional<std::size_t> place_;  // of the first that is too deep
  bool isPlaceOfPart_ = false;        // The last part of the key is at that place.
  bool isPlaceNext_ = false;
};

}  // namespace

std::optional<std::size_t> farTooDeep(std::string_view text, int deepest) {
  return DepthScanner(text, deepest).find();
}

}  // namespace rotatebook::document
