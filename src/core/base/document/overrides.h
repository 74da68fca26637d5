// --set: values from the command line that replace those of a document.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/document/toml_tree.h"

namespace rotatebook::document {

inline constexpr std::size_t kMaxOverrides = 1000;

/// Keys of which a section has at most one, so that an override of one replaces the others.
struct Alternatives {
  std::string_view section;  ///< Its last name: "initial" for [initial] and [panel.initial].
  std::span<const std::string_view> keys;
};

/// Returns whether `one` and `other` are different keys of `section` of which it has at most one.
bool areAlternatives(std::span<const Alternatives> all, std::string_view section,
                     std::string_view one, std::string_view other);

/// Applies each "key.path=value" to `root`, a table, in order. The value is TOML, or else a bare
/// string. The key of an array's element is its number from 0: panel.0.label. Setting one of
/// `alternatives` removes the others. Only the form is checked here. Goes on after one that is
/// wrong, and throws DocumentError in the end, with overrideLocation(); InputError for more than
/// kMaxOverrides.
void applyOverrides(TomlNode& root, std::span<const std::string> overrides,
                    std::span<const Alternatives> alternatives = {});

/// Puts `value` in place of the one of `key`, such as "section.key", as applyOverrides() does.
/// Problems with the key have `location`. Throws DocumentError.
void putValue(TomlNode& root, std::string_view key, TomlNode value, const std::string& location,
              std::span<const Alternatives> alternatives = {});

/// Returns the location of an override for messages: "--set KEY=VALUE", printable and not too long.
std::string overrideLocation(std::string_view text);

}  // namespace rotatebook::document
