// A key of a scene file as one row, from which it is read, printed and documented; for this room
// alone.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/text.h"
#include "scene/keys/key_row.h"
#include "scene/toml_text.h"
#include "scene/value_reader.h"

namespace rotatebook::scene {

/// How values of one sort are read, written as TOML, and described.
template <typename T>
struct Kind {
  std::function<T(const ValueReader&)> read;  ///< Throws InputError.
  std::function<std::string(const T&)> text;  ///< As TOML.
  std::string allowed;                        ///< As messages have it: "a positive number".
  std::string comment{};                      ///< Of keys without a comment of their own.
};

/// What is said of a key. Comments are printed after values; the others are Markdown.
struct KeyText {
  std::string comment{};    ///< Its kind's, if empty.
  std::string meaning{};    ///< The comment, if empty.
  std::string byDefault{};  ///< The text of the default value, if empty.
  std::string allowed{};    ///< Its kind's, if empty.
};

/// One key of a section that is read into an S.
template <typename S>
struct Key {
  std::string_view name;
  std::function<void(const ValueReader&, S&)> read;  ///< Throws InputError.
  /// The value as TOML; empty if there is none to print.
  std::function<std::string(const S&)> text;
  KeyText words;
};

template <typename S>
using Keys = std::vector<Key<S>>;

/// The key of a value, or optional value, that `field` finds in an S.
template <typename S, typename Field, typename T>
Key<S> keyAt(std::string_view name, Field field, const Kind<T>& kind, KeyText words = {}) {
  if (words.comment.empty()) words.comment = kind.comment;
  if (words.allowed.empty()) words.allowed = kind.allowed;
  return {name,
          [field, read = kind.read](const ValueReader& value, S& into) {
            std::invoke(field, into) = read(value);
          },
          [field, text = kind.text](const S& from) -> std::string {
            const auto& value = std::invoke(field, from);
            if constexpr (std::is_same_v<decltype(value), const std::optional<T>&>) {
              return value ? text(*value) : "";
            } else {
              return text(value);
            }
          },
          std::move(words)};
}

/// The same of a member.
template <typename S, typename Member, typename T>
Key<S> key(std::string_view name, Member S::*member, const Kind<T>& kind, KeyText words = {}) {
  return keyAt<S>(name, member, kind, std::move(words));
}

/// The names of the keys, and what `read(key, value)` does with each.
template <typename S, typename Read>
std::vector<Field> fieldsOf(const Keys<S>& keys, const Read& read) {
  std::vector<Field> fields;
  fields.reserve(keys.size());
  for (const Key<S>& key : keys) {
    fields.push_back({key.name, [&key, read](const ValueReader& value) { read(key, value); }});
  }
  return fields;
}

/// Reads a section, in the order of the text. Throws InputError.
template <typename S>
void readKeys(const ValueReader& section, const Keys<S>& keys, S& into) {
  section.readTable(fieldsOf(
      keys, [&into](const Key<S>& key, const ValueReader& value) { key.read(value, into); }));
}

/// "KEY = VALUE  # COMMENT", empty where there is nothing to print.
template <typename S>
std::string lineOf(const Key<S>& key, const S& from) {
  const std::string text = key.text(from);
  if (text.empty()) return "";
  const std::string comment = key.words.comment.empty() ? "" : "  # " + key.words.comment;
  return std::string(key.name) + " = " + text + comment + "\n";
}

/// The lines of all keys.
template <typename S>
std::string linesOf(const Keys<S>& keys, const S& from) {
  std::string lines;
  for (const Key<S>& key : keys) lines += lineOf(key, from);
  return lines;
}

/// All keys on one line: "{ KEY = VALUE, ... }".
template <typename S>
std::string inlineTable(const Keys<S>& keys, const S& from) {
  std::vector<std::string> parts;
  for (const Key<S>& key : keys) {
    const std::string text = key.text(from);
    if (!text.empty()) parts.push_back(std::string(key.name) + " = " + text);
  }
  return "{ " + joined(parts) + " }";
}

/// `text` with what is in "quotes" as code of Markdown.
std::string quotedAsCode(std::string_view text);

/// What the documentation says of the keys; `section` is empty, or ends in a dot.
template <typename S>
std::vector<KeyRow> rowsOf(std::string_view section, const Keys<S>& keys) {
  std::vector<KeyRow> rows;
  for (const auto& [name, read, text, words] : keys) {
    rows.push_back({std::string(section) + std::string(name),
                    words.byDefault.empty() ? "`" + text(S{}) + "`" : words.byDefault,
                    quotedAsCode(words.allowed),
                    words.meaning.empty() ? words.comment : words.meaning});
  }
  return rows;
}

}  // namespace rotatebook::scene
