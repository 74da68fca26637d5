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

#include "base/document/toml_text.h"
#include "base/document/value_reader.h"
#include "base/text.h"
#include "scene/key_rows.h"

namespace rotatebook::scene {

using document::Field;
using document::NumberRange;
using document::readEach;
using document::tomlNumber;
using document::tomlString;
using document::ValueReader;

/// Reads a part of a value, such as "0" of a vector. Throws InputError if there is no such part, or
/// the whole isn't allowed then.
template <typename T>
using ReadPart = std::function<void(const ValueReader&, std::string_view part, T& into)>;

/// The functions that read and print values of one kind, and what is known of them.
template <typename T>
struct Kind {
  std::function<T(const ValueReader&)> read;  ///< Throws InputError.
  std::function<std::string(const T&)> text;  ///< Prints as TOML.
  std::string allowed;                        ///< As in messages: "a positive number".
  std::string comment{};                      ///< For keys without a comment of their own.
  ValueForm form{};
  ReadPart<T> readPart{};  ///< None of values without parts.
};

/// The facts and texts in a key's row. Comments are printed after values; the other texts are
/// Markdown.
struct KeyText {
  std::string comment{};    ///< If empty, that of its kind.
  std::string meaning{};    ///< Without unit and models. If empty, the comment.
  std::string byDefault{};  ///< If empty, the default value as TOML.
  std::string allowed{};    ///< If empty, that of its kind.
  std::string_view unit{};  ///< If empty, the SI's of its form's dimension.
  KeyModels models = kOfAll;
  Affects affects = Affects::Motion;
};

/// A key of a section that is read into an S.
template <typename S>
struct Key {
  std::string_view name;
  std::function<void(const ValueReader&, S&)> read;  ///< Throws InputError.
  /// Prints the value as TOML; empty if there is none to print.
  std::function<std::string(const S&)> text;
  KeyText documentation;
  ValueForm form{};
  ReadPart<S> readPart{};  ///< None of values without parts.
};

template <typename S>
using Keys = std::vector<Key<S>>;

/// Returns the key of a value, or optional value, that `field` finds in an S.
template <typename S, typename Field, typename T>
Key<S> keyAt(std::string_view name, Field field, const Kind<T>& kind, KeyText documentation = {}) {
  if (documentation.comment.empty()) documentation.comment = kind.comment;
  if (documentation.allowed.empty()) documentation.allowed = kind.allowed;
  ReadPart<S> readPart;
  if (kind.readPart) {
    readPart = [field, read = kind.readPart](const ValueReader& number, std::string_view part,
                                             S& into) {
      auto& value = std::invoke(field, into);
      if constexpr (std::is_same_v<decltype(value), std::optional<T>&>) {
        read(number, part, *value);
      } else {
        read(number, part, value);
      }
    };
  }
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
          std::move(documentation),
          kind.form,
          std::move(readPart)};
}

/// Like keyAt(), for a member of S.
template <typename S, typename Member, typename T>
Key<S> key(std::string_view name, Member S::*member, const Kind<T>& kind,
           KeyText documentation = {}) {
  return keyAt<S>(name, member, kind, std::move(documentation));
}

/// Returns keys all of which affect that alone.
template <typename S>
Keys<S> allOf(Affects affects, Keys<S> keys) {
  for (Key<S>& key : keys) key.documentation.affects = affects;
  return keys;
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

/// The keys that are printed.
enum class Printed {
  All,
  OfMotion,  ///< Keys that affect the motion, without comments.
};

/// Returns "KEY = VALUE  # COMMENT"; empty if there is no value to print.
template <typename S>
std::string lineOf(const Key<S>& key, const S& from, Printed printed = Printed::All) {
  const bool isAll = printed == Printed::All;
  if (!isAll && key.documentation.affects != Affects::Motion) return "";
  const std::string text = key.text(from);
  if (text.empty()) return "";
  const std::string& comment = key.documentation.comment;
  return std::string(key.name) + " = " + text +
         (isAll && !comment.empty() ? "  # " + comment : "") + "\n";
}

/// Returns the lines of the keys.
template <typename S>
std::string linesOf(const Keys<S>& keys, const S& from, Printed printed = Printed::All) {
  std::string lines;
  for (const Key<S>& key : keys) lines += lineOf(key, from, printed);
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

/// Returns the row of a key whose default is `value`, as TOML.
KeyRow rowOf(std::string name, const KeyText& key, const ValueForm& form, std::string value);

/// Returns the rows of the keys; `section` is empty, or ends in a dot.
template <typename S>
std::vector<KeyRow> rowsOf(std::string_view section, const Keys<S>& keys) {
  std::vector<KeyRow> rows;
  for (const Key<S>& key : keys) {
    const bool isStated = key.documentation.byDefault.empty();
    rows.push_back(rowOf(std::string(section) + std::string(key.name), key.documentation, key.form,
                         isStated ? key.text(S{}) : ""));
  }
  return rows;
}

}  // namespace rotatebook::scene
