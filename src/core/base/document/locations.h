// The locations of what a document states, for messages about it when its tree is gone.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/document/toml_tree.h"
#include "base/error.h"

namespace rotatebook::document {

/// The locations of a document's values.
struct Locations {
  /// As TomlNode has them, by key: "overlay.show.0"; that of the whole document is of "".
  std::map<std::string, std::string, std::less<>> byKey{};

  /// Returns the location of the first of `keys` that is stated, or else of the whole document.
  std::string of(const std::vector<std::string>& keys) const;

  /// Returns what `work` returns, and throws an InputError of it again with the location of `keys`.
  template <typename Work>
  auto failAt(const std::vector<std::string>& keys, const Work& work) const {
    try {
      return work();
    } catch (const InputError& error) {
      document::failAt(of(keys), error.what());
    }
  }

  /// Finds no difference, as the same may be stated elsewhere.
  friend bool operator==(const Locations&, const Locations&) { return true; }
};

/// Returns the locations of all values of `root`.
Locations locationsOf(const TomlNode& root);

}  // namespace rotatebook::document
