// A row for a key of a scene file, from which the key is read, printed and documented. Inside the
// room only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/text.h"
#include "document/toml_text.h"
#include "document/value_reader.h"
#include "scene/keys/key_row.h"

namespace rotatebook::scene {

using document::Field;
using document::NumberRange;
using document::readEach;
using document::tomlNumber;
using document::tomlString;
using document::ValueReader;

/// The functions that read, print and describe values of one kind.
template <typename T>
struct Kind {
  std::function<T(const ValueReader&)> read;  ///< Throws InputError.
  std::function<std::string(const T&)> text;  ///< Prints as TOML.
  std::string allowed;                        ///< As in messages: "a positive number".
  std::string comment{};                      ///< For keys without a comment of their own.
};

/// The documentation of a key. Comments are printed after values; the other texts are Markdown.
struct KeyText {
  std::string comment{};    ///< If empty, that of its kind.
  std::string meaning{};    ///< If empty, the comment.
  std::string byDefault{};  ///< If empty, the default value as TOML.
  std::string allowed{};    ///< If empty, that of its kind.
};

/// A key of a section that is read into an S.
template <typename S>
struct Key {
  std::string_view name;
  std::function<void(const ValueReader&, S&)> read;  ///< Throws InputError.
  /// Prints the value as TOML; empty if there is none to print.
  std::function<std::string(const S&)> text;
  KeyText documentation;
};

template <typename S>
using Keys = std::vector<Key<S>>;

/// Returns the key of a value, or optional value, that `field` finds in an S.
template <typename S, typename Field, typename T>
Key<S> keyAt(std::string_view name, Field field, const Kind<T>& kind, KeyText documentation = {}) {
  if (documentation.comment.empty()) documentation.comment = kind.comment;
  if (documentation.allowed.empty()) documentation.allowed = kind.allowed;
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
          std::move(documentation)};
}

/// Like keyAt(), for a member of S.
template <typename S, typename Member, typename T>
Key<S> key(std::string_view name, Member S::*member, const Kind<T>& kind,
           KeyText documentation = {}) {
  return keyAt<S>(name, member, kind, std::move(documentation));
}

/// Returns a field for each key; its value is passed to `read(key, value)`.
template <typename S, typename Read>
std::vector<Field> fieldsOf(const Keys<S>& keys, const Read& read) {
  std::vector<Field> fields;
  fields.reserve(keys.size());
  for (const Key<S>& key : keys) {
    fields.push_back({key.name, [&key, read](const ValueReader& value) { read(key, value); }});
  }
  return fields;
}

/// Reads a section in the order of its text. Throws InputError.
template <typename S>
void readKeys(const ValueReader& section, const Keys<S>& keys, S& into) {
  section.readTable(fieldsOf(
      keys, [&into](const Key<S>& key, const ValueReader& value) { key.read(value, into); }));
}

/// Returns "KEY = VALUE  # COMMENT"; empty if there is no value to print.
template <typename S>
std::string lineOf(const Key<S>& key, const S& from) {
  const std::string text = key.text(from);
  if (text.empty()) return "";
  const std::string comment =
      key.documentation.comment.empty() ? "" : "  # " + key.documentation.comment;
  return std::string(key.name) + " = " + text + comment + "\n";
}

/// Returns the lines of all keys.
template <typename S>
std::string linesOf(const Keys<S>& keys, const S& from) {
  std::string lines;
  for (const Key<S>& key : keys) lines += lineOf(key, from);
  return lines;
}

/// Returns all keys on one line: "{ KEY = VALUE, ... }".
template <typename S>
std::string inlineTable(const Keys<S>& keys, const S& from) {
  std::vector<std::string> parts;
  for (const Key<S>& key : keys) {
    const std::string text = key.text(from);
    if (!text.empty()) parts.push_back(std::string(key.name) + " = " + text);
  }
  return "{ " + joined(parts) + " }";
}

/// Returns `text` with whatever is in "quotes" as Markdown code.
std::string quotedAsCode(std::string_view text);

/// Returns the documentation of the keys; `section` is empty, or ends in a dot.
template <typename S>
std::vector<KeyRow> rowsOf(std::string_view section, const Keys<S>& keys) {
  std::vector<KeyRow> rows;
  for (const auto& [name, read, text, documentation] : keys) {
    rows.push_back(
        {std::string(section) + std::string(name),
         documentation.byDefault.empty() ? "`" + text(S{}) + "`" : documentation.byDefault,
         quotedAsCode(documentation.allowed),
         documentation.meaning.empty() ? documentation.comment : documentation.meaning});
  }
  return rows;
}

}  // namespace rotatebook::scene
