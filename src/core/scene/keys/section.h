// A section of a scene file: all that its keys need to be read, printed and documented; for this
// room alone.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "scene/keys/key.h"

namespace rotatebook::scene {

/// A section of an Owner: a scene, or a motion of it.
template <typename Owner>
struct Section {
  std::string_view name;
  std::function<void(const ValueReader&, Owner&)> read;  ///< Throws InputError.
  std::function<std::string(const Owner&)> lines;        ///< As TOML, without its head.
  std::vector<KeyRow> rows;                              ///< For the documentation.
};

/// The section whose keys are read into what `part` finds in an Owner. `finish` checks them
/// together.
template <typename Owner, typename S, typename Part>
Section<Owner> section(std::string_view name, Part part, const Keys<S>& keys,
                       void (*finish)(const ValueReader&, S&) = nullptr) {
  return {name,
          [=, &keys](const ValueReader& value, Owner& owner) {
            S& into = std::invoke(part, owner);
            readKeys(value, keys, into);
            if (finish != nullptr) finish(value, into);
          },
          [=, &keys](const Owner& owner) {
            const S& from = std::invoke(part, owner);
            return linesOf(keys, from);
          },
          rowsOf(std::string(name) + ".", keys)};
}

/// Adds what reads the sections of `owner`.
template <typename Owner>
void addFields(std::vector<Field>& fields, std::span<const Section<Owner>> sections,
               std::type_identity_t<Owner>& owner) {
  for (const Section<Owner>& one : sections) {
    fields.push_back({one.name, [&](const ValueReader& value) { one.read(value, owner); }});
  }
}

/// The sections, each with its head after an empty line; nothing for one without lines. `parent` is
/// empty, or what comes before their names: "panel.".
template <typename Owner>
std::string textOf(std::span<const Section<Owner>> sections,
                   const std::type_identity_t<Owner>& owner, const std::string& parent = "") {
  std::string text;
  for (const Section<Owner>& one : sections) {
    const std::string lines = one.lines(owner);
    if (!lines.empty()) text += "\n[" + parent + std::string(one.name) + "]\n" + lines;
  }
  return text;
}

}  // namespace rotatebook::scene
