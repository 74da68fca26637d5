// A section of a scene file, with all that it takes to read, print and document its keys. Inside
// the room only.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "scene/keys/key.h"

namespace rotatebook::scene {

/// A section of an Owner, which is a scene or one of its motions.
template <typename Owner>
struct Section {
  std::string_view name;
  std::function<void(const ValueReader&, Owner&)> read;  ///< Throws InputError.
  /// Prints as TOML, without the header.
  std::function<std::string(const Owner&, const Printed&)> lines;
  std::vector<KeyRow> rows;  ///< For the documentation.
  /// Prints each table of an array of tables, likewise, in place of `lines`.
  std::function<std::vector<std::string>(const Owner&, const Printed&)> tables{};
};

/// Returns the section whose keys are read into what `part` finds in an Owner. `finish` checks them
/// together.
template <typename Owner, typename S, typename Part>
Section<Owner> section(std::string_view name, Part part, Keys<S> keys,
                       void (*finish)(const ValueReader&, S&) = nullptr) {
  return {name,
          [=](const ValueReader& value, Owner& owner) {
            S& into = std::invoke(part, owner);
            readKeys(value, keys, into);
            if (finish != nullptr) finish(value, into);
          },
          [=](const Owner& owner, const Printed& printed) {
            const S& from = std::invoke(part, owner);
            return linesOf(keys, from, printed);
          },
          rowsOf(std::string(name) + ".", keys)};
}

/// Adds the fields that read the sections into `owner`.
template <typename Owner>
void addFields(std::vector<Field>& fields, std::span<const Section<Owner>> sections,
               std::type_identity_t<Owner>& owner) {
  for (const Section<Owner>& one : sections) {
    fields.push_back({one.name, [&](const ValueReader& value) { one.read(value, owner); }});
  }
}

/// Returns the sections as TOML, each with its header after an empty line; sections without lines
/// are left out. `parent` is empty, or the prefix of their names: "panel.".
template <typename Owner>
std::string textOf(std::span<const Section<Owner>> sections,
                   const std::type_identity_t<Owner>& owner, const Printed& printed,
                   const std::string& parent = "") {
  std::string text;
  for (const Section<Owner>& one : sections) {
    const std::string name = parent + std::string(one.name);
    if (one.tables) {
      for (const std::string& table : one.tables(owner, printed))
        text += "\n[[" + name + "]]\n" + table;
      continue;
    }
    const std::string lines = one.lines(owner, printed);
    if (!lines.empty()) text += "\n[" + name + "]\n" + lines;
  }
  return text;
}

}  // namespace rotatebook::scene
