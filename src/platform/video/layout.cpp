#include "video/layout.h"

#include <algorithm>
#include <charconv>
#include <cstddef>

#include <fmt/core.h>

#include "base/text.h"

namespace rotatebook::video {
namespace {

constexpr std::uint64_t kMaxRead = 1'000'000;  // Limit of what is compared at once. [bytes]

using Words = std::vector<std::string_view>;

Words wordsOf(std::string_view text) {
  Words words;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find(' '), text.size());
    if (length > 0) words.push_back(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return words;
}

/// Returns the bytes of a word such as "00ff", or of each of "00/80".
std::vector<std::string> bytesOf(std::string_view word) {
  std::vector<std::string> texts(1);
  for (std::size_t i = 0; i < word.size(); i += 2) {
    if (word[i] == '/') {
      texts.emplace_back();
      ++i;
    }
    unsigned value = 0;
    std::from_chars(word.data() + i, word.data() + i + 2, value, 16);
    texts.back() += static_cast<char>(value);
  }
  return texts;
}

bool isHex(std::string_view word) {
  return word.find_first_not_of("0123456789abcdef/") == std::string_view::npos;
}

/// Reads a part's bytes word by word.
class ContentMatcher {
 public:
  ContentMatcher(const LayoutValues& values, std::istream& file, std::uint64_t at,
                 std::uint64_t end)
      : values_(values), file_(file), at_(at), end_(end) {}

  /// Returns whether the content is as `words` say, as far as they do.
  bool matches(const Words& words) {
    std::size_t group = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] == "(") {
        group = i;
        if (at_ == end_)
          i = static_cast<std::size_t>(std::ranges::find(words, "*") - words.begin());
      } else if (words[i] == "*") {
        if (at_ < end_) i = group;
      } else if (!takes(words[i])) {
        return false;
      }
    }
    return true;
  }
  std::uint64_t at() const { return at_; }

 private:
  bool takes(std::string_view word) {
    if (isHex(word)) return takesOneOf(bytesOf(word));
    const auto texts = values_.texts.find(word);
    if (texts != values_.texts.end()) return takesOneOf(texts->second);
    const std::size_t colon = word.find(':');
    const std::string_view name = word.substr(0, colon);
    std::uint64_t count = end_ - at_;
    if (colon != std::string_view::npos) {
      std::from_chars(word.data() + colon + 1, word.data() + word.size(), count);
    }
    if (count > end_ - at_) return false;
    at_ += count;
    if (name == "any") return true;
    if (name == "payload") return isWithin(name, count);
    if (count > kMaxRead) return false;
    const std::string bytes = bytesAt(file_, at_ - count, count);
    if (name == "zero") return bytes.find_first_not_of('\0') == std::string::npos;
    return count <= 8 && isWithin(name, bigEndian(bytes));
  }

  bool isWithin(std::string_view name, std::uint64_t number) const {
    const auto& [min, max] = values_.numbers.at(name);
    return min <= number && number <= max;
  }

  bool takesOneOf(const std::vector<std::string>& texts) {
    const std::uint64_t count = texts.front().size();
    if (count > end_ - at_) return false;
    at_ += count;
    return std::ranges::find(texts, bytesAt(file_, at_ - count, count)) != texts.end();
  }

  const LayoutValues& values_;
  std::istream& file_;
  std::uint64_t at_, end_;
};

/// Compares a file with a layout.
class LayoutMatcher {
 public:
  LayoutMatcher(std::span<const LayoutRow> rows, const LayoutValues& values, std::istream& file,
                PartReader reader, PartOrder order)
      : rows_(rows), values_(values), file_(file), reader_(reader), order_(order) {
    for (const LayoutRow& row : rows) words_.push_back(wordsOf(row.content));
  }

  /// Returns the first difference of the parts from offset `at` to `end` from the rows of `level`
  /// from `first` on; `outer` is the name of what they are in.
  std::string difference(std::size_t first, int level, const std::string& outer, std::uint64_t at,
                         std::uint64_t end) const {
    std::map<std::size_t, int> counts;
    std::size_t last = first;
    while (at < end) {
      const auto part = partAt(file_, reader_, at, end);
      if (!part || part->end > end) return nameIn(outer) + " holds damaged or foreign bytes";
      const std::size_t row = rowFor(*part, first, level, counts);
      if (row == rows_.size()) return oddPart(*part, first, level, outer);
      if (row < last && order_ == PartOrder::AsRows) {
        return fmt::format("{} has its {} before its {}", nameIn(outer), nameOf(rows_[last]),
                           nameOf(rows_[row]));
      }
      last = row;
      const std::string inner = differenceIn(row, pathOf(outer, nameOf(rows_[row])), *part);
      if (!inner.empty()) return inner;
      at = part->end;
    }
    return missing(first, level, outer, counts);
  }

 private:
  static std::string nameIn(const std::string& path) { return path.empty() ? "the file" : path; }
  static std::string pathOf(const std::string& outer, const std::string& name) {
    return outer.empty() ? name : outer + "/" + name;
  }
  static std::string nameOf(const LayoutRow& row) {
    return std::string(row.name.empty() ? row.id : row.name);
  }

  std::string differenceIn(std::size_t row, const std::string& path, const Part& part) const {
    ContentMatcher content(values_, file_, part.content, part.end);
    if (!content.matches(words_[row])) return path + " differs";
    const int level = rows_[row].level + 1;
    const bool isOuter = row + 1 < rows_.size() && rows_[row + 1].level == level;
    if (isOuter) return difference(row + 1, level, path, content.at(), part.end);
    return content.at() == part.end ? "" : path + " is too long";
  }

  /// Calls `action` with each row of `level` from `first` on.
  template <typename Action>
  void forEachRow(std::size_t first, int level, const Action& action) const {
    for (std::size_t row = first; row < rows_.size() && rows_[row].level >= level; ++row) {
      if (rows_[row].level == level) action(row);
    }
  }

  /// Returns the row that has room for `part`, and counts it there; rows_.size() if there is none.
  std::size_t rowFor(const Part& part, std::size_t first, int level,
                     std::map<std::size_t, int>& counts) const {
    std::size_t found = rows_.size();
    forEachRow(first, level, [&](std::size_t row) {
      const bool hasRoom = rows_[row].id == part.id && counts[row] < rows_[row].max;
      if (hasRoom && found == rows_.size()) found = row;
    });
    if (found < rows_.size()) ++counts[found];
    return found;
  }

  std::string oddPart(const Part& part, std::size_t first, int level,
                      const std::string& outer) const {
    std::string known;
    forEachRow(first, level, [&](std::size_t row) {
      if (rows_[row].id == part.id) known = nameOf(rows_[row]);
    });
    if (known.empty())
      return fmt::format("{} holds a foreign \"{}\"", nameIn(outer), oneLine(part.id));
    return fmt::format("{} holds one {} too many", nameIn(outer), known);
  }

  std::string missing(std::size_t first, int level, const std::string& outer,
                      std::map<std::size_t, int>& counts) const {
    std::string text;
    forEachRow(first, level, [&](std::size_t row) {
      if (text.empty() && counts[row] < rows_[row].min) {
        text = fmt::format("{} lacks {}", nameIn(outer), nameOf(rows_[row]));
      }
    });
    return text;
  }

  std::span<const LayoutRow> rows_;
  const LayoutValues& values_;
  std::istream& file_;
  PartReader reader_;
  PartOrder order_;
  std::vector<Words> words_;
};

}  // namespace

std::string bytesAt(std::istream& file, std::uint64_t at, std::uint64_t count) {
  file.clear();
  file.seekg(static_cast<std::streamoff>(at));
  std::string bytes(count, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

std::optional<Part> partAt(std::istream& file, PartReader reader, std::uint64_t at,
                           std::uint64_t end) {
  return reader(bytesAt(file, at, kMaxHead), at, end);
}

std::string bigEndianBytes(std::uint64_t number, int count) {
  std::string bytes;
  for (int i = count - 1; i >= 0; --i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
  return bytes;
}

std::uint64_t sizeOf(std::istream& file) {
  file.clear();
  file.seekg(0, std::ios::end);
  return static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
}

std::string differenceFrom(std::span<const LayoutRow> rows, const LayoutValues& values,
                           std::istream& file, PartReader reader, PartOrder order) {
  return LayoutMatcher(rows, values, file, reader, order).difference(0, 0, "", 0, sizeOf(file));
}

}  // namespace rotatebook::video
