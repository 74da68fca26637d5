// A row for a key of a scene file, from which the key is read, printed and documented. Inside the
// room only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/document/toml_text.h"
#include "base/document/value_reader.h"
#include "base/text.h"
#include "scene/key_row.h"

namespace rotatebook::scene {

using document::Field;
using document::NumberRange;
using document::readEach;
using document::tomlNumber;
using document::tomlString;
using document::ValueReader;

/// The facts and texts in a key's row. Comments are printed after values; the other texts are
/// Markdown.
struct KeyText {
  std::string_view comment{};    ///< If empty, the choices of its form.
  std::string_view meaning{};    ///< Without unit and models. If empty, the comment.
  std::string_view byDefault{};  ///< If empty, the default value as TOML.
  std::string_view allowed{};    ///< If empty, as its form says.
  std::string_view unit{};       ///< If empty, the SI's of its form's dimension.
  KeyModels models = kOfAll;
  Affects affects = Affects::Motion;
};

/// A key of a section that is read into an S. Rows are made by the functions of kinds.h.
template <typename S>
struct Key {
  std::string_view name;
  ValueForm form;
  /// Throws InputError.
  void (*reader)(const ValueReader&, const ValueForm&, S&);
  /// Prints the value as TOML; empty if there is none to print.
  std::string (*printer)(const S&);
  KeyText documentation{};
  /// Reads a part, such as "0" of a vector; null for values without parts. Throws InputError if
  /// there is no such part, or the whole isn't allowed then.
  void (*partReader)(const ValueReader&, std::string_view part, const ValueForm&, S&) = nullptr;

  void read(const ValueReader& value, S& into) const { reader(value, form, into); }
  std::string text(const S& from) const { return printer(from); }
  bool hasParts() const { return partReader != nullptr; }
  void readPart(const ValueReader& value, std::string_view part, S& into) const {
    partReader(value, part, form, into);
  }
};

/// Rows that a constexpr array has.
template <typename S>
using Keys = std::span<const Key<S>>;

/// Returns keys all of which affect that alone.
template <typename S, std::size_t N>
constexpr std::array<Key<S>, N> allOf(Affects affects, std::array<Key<S>, N> keys) {
  for (Key<S>& key : keys) key.documentation.affects = affects;
  return keys;
}

/// Returns keys all of which are of these models.
template <typename S, std::size_t N>
constexpr std::array<Key<S>, N> allOf(KeyModels models, std::array<Key<S>, N> keys) {
  for (Key<S>& key : keys) key.documentation.models = models;
  return keys;
}

/// Returns a field for each key; its value is passed to `read(key, value)`.
template <typename S, typename Read>
std::vector<Field> fieldsOf(Keys<S> keys, const Read& read) {
  std::vector<Field> fields;
  fields.reserve(keys.size());
  for (const Key<S>& key : keys) {
    fields.push_back({key.name, [&key, read](const ValueReader& value) { read(key, value); }});
  }
  return fields;
}

/// Returns a field for each key, which reads it into `into`.
template <typename S>
std::vector<Field> fieldsInto(std::type_identity_t<S>& into, Keys<S> keys) {
  return fieldsOf(keys,
                  [&into](const Key<S>& key, const ValueReader& value) { key.read(value, into); });
}

/// Reads a section in the order of its text. Throws InputError.
template <typename S>
void readKeys(const ValueReader& section, Keys<S> keys, std::type_identity_t<S>& into) {
  section.readTable(fieldsInto(into, keys));
}

/// Returns the allowed values as in messages: "a positive number".
std::string allowedOf(const KeyText& key, const ValueForm& form);
/// Returns the comment that is printed after the value; empty if there is none.
std::string commentOf(const KeyText& key, const ValueForm& form);

/// The keys that are printed.
struct Printed {
  bool ofMotion = false;  ///< Only keys that affect the motion, without comments.
  bool isBrief = false;   ///< Only keys that aren't as by default, without comments.
  std::span<const std::string_view> leftOut{};  ///< The names of keys that aren't.

  bool has(std::string_view key, Affects affects) const {
    return (!ofMotion || affects == Affects::Motion) && std::ranges::count(leftOut, key) == 0;
  }
};

/// Returns "KEY = VALUE  # COMMENT"; empty if there is no value to print.
template <typename S>
std::string lineOf(const Key<S>& key, const std::type_identity_t<S>& from,
                   const Printed& printed = {}) {
  if (!printed.has(key.name, key.documentation.affects)) return "";
  const std::string text = key.text(from);
  const bool isRequired = key.documentation.byDefault.starts_with("required");
  if (text.empty() || (printed.isBrief && !isRequired && text == key.text(S{}))) return "";
  // The integrator's text has its choices, which depend on the model, as a comment.
  const std::string line = std::string(key.name) + " = " + text;
  if (printed.isBrief) return line.substr(0, line.find("  # ")) + "\n";
  const std::string comment = printed.ofMotion ? "" : commentOf(key.documentation, key.form);
  return line + (comment.empty() ? "" : "  # " + comment) + "\n";
}

/// Returns the lines of the keys.
template <typename S>
std::string linesOf(Keys<S> keys, const std::type_identity_t<S>& from,
                    const Printed& printed = {}) {
  std::string lines;
  for (const Key<S>& key : keys) lines += lineOf(key, from, printed);
  return lines;
}

/// Returns all keys on one line: "{ KEY = VALUE, ... }".
template <typename S>
std::string inlineTable(Keys<S> keys, const std::type_identity_t<S>& from) {
  std::vector<std::string> parts;
  for (const Key<S>& key : keys) {
    const std::string text = key.text(from);
    if (!text.empty()) parts.push_back(std::string(key.name) + " = " + text);
  }
  return "{ " + joined(parts) + " }";
}

/// Returns the row of a key whose default is `value`, as TOML.
KeyRow rowOf(std::string name, const KeyText& key, const ValueForm& form, std::string value);

/// Adds that of the key `name` of `section`. It is no template, as the live book's size counts.
void addRow(std::vector<KeyRow>& rows, std::string_view section, std::string_view name,
            const KeyText& key, const ValueForm& form, std::string value);

/// Returns the rows of the keys; `section` is empty, or ends in a dot.
template <typename S>
std::vector<KeyRow> rowsOf(std::string_view section, Keys<S> keys) {
  std::vector<KeyRow> rows;
  for (const Key<S>& key : keys) {
    const bool isStated = key.documentation.byDefault.empty();
    addRow(rows, section, key.name, key.documentation, key.form, isStated ? key.text(S{}) : "");
  }
  return rows;
}

/// Returns the rows of the keys of a table that is a value.
template <auto kKeys>
std::vector<KeyRow> membersOf() {
  return rowsOf("", kKeys());
}

}  // namespace rotatebook::scene
