// Values of a scene file on their way into a Scene: typed, checked, and named in messages.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "base/error.h"
#include "scene/names.h"
#include "scene/toml_tree.h"

namespace rotatebook::scene {

/// The finite numbers that a value may have, and how a message calls them.
struct NumberRange {
  std::string_view words;  ///< "a positive number"
  double min;              ///< The least that is allowed.
  double max;              ///< The greatest that is allowed.
};

inline constexpr NumberRange kPositive{"a positive number",
                                       std::numeric_limits<double>::denorm_min(),
                                       std::numeric_limits<double>::max()};

inline constexpr NumberRange kNumber{"a number", std::numeric_limits<double>::lowest(),
                                     std::numeric_limits<double>::max()};

/// Wide enough for any book, and narrow enough that no product of squares leaves the range of
/// double.
inline constexpr NumberRange kDirections{"three numbers from -1e9 to 1e9, not all zero", -1e9, 1e9};

// What messages call other values that are allowed.
inline constexpr std::string_view kFlagWords = "true or false";
std::string integerWords(int min, int max);
std::string textWords(std::size_t most);

class ValueReader;

/// A key that a table may have, and what to do with its value.
struct Field {
  std::string_view key;
  std::function<void(const ValueReader&)> read;
};

/// One value and its name, such as "simulation.substeps". It refers to the tree, which must outlive
/// it. What a value isn't allowed to be, each member reports as InputError "PLACE: NAME must be
/// EXPECTED, not FOUND".
class ValueReader {
 public:
  /// `name` is empty for the whole file.
  ValueReader(const TomlNode& node, std::string name) : node_(&node), name_(std::move(name)) {}

  const std::string& name() const { return name_; }
  const TomlNode& node() const { return *node_; }

  /// A text of at most `most` letters without control characters other than tab and line break.
  std::string text(std::size_t most) const;
  bool flag() const;
  int integer(int min, int max) const;
  /// Whole numbers are numbers too; NaN and infinity are in no range.
  double number(const NumberRange& range) const;
  /// Three numbers, each within `range`, whose words are those for all three.
  Eigen::Vector3d vector(const NumberRange& range) const;
  /// Three numbers that aren't all zero.
  Eigen::Vector3d direction() const;
  /// Index of the text in `names`.
  std::size_t choice(std::span<const std::string_view> names) const;
  /// The value whose name the text is.
  template <typename T, std::size_t N>
  T oneOf(const std::array<Named<T>, N>& choices) const {
    return choices[choice(namesOf(choices))].value;
  }

  /// The elements of an array of that length. They keep the array's name.
  std::vector<ValueReader> elements(std::size_t count, const std::string& expected) const;
  /// The elements of an array that isn't empty. They keep the array's name.
  std::vector<ValueReader> list(const std::string& expected) const;
  /// The tables of an array that isn't empty, or the one table that this is.
  std::vector<ValueReader> tables(const std::string& expected) const;
  /// Reads a table, in the order of the text, and refuses keys that aren't among `fields`.
  void readTable(const std::vector<Field>& fields) const;
  /// The value of a key of this table, if it is there.
  std::optional<ValueReader> find(std::string_view key) const;
  /// The value of a key of that section of this table, if both are there.
  std::optional<ValueReader> find(std::string_view section, std::string_view key) const;

  /// Throws "NAME must be EXPECTED, not FOUND".
  [[noreturn]] void mismatch(const std::string& expected) const;
  /// Throws "PROBLEM", at this value's place.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  std::string nameOfKey(std::string_view key) const;
  [[noreturn]] void refuseKey(const TomlEntry& entry, const std::vector<Field>& fields) const;

  const TomlNode* node_;
  std::string name_;
};

/// Does what physics may refuse: that is physics' to say; the place is ours.
template <typename Check>
void failAtValue(const ValueReader& value, const Check& check) {
  try {
    check();
  } catch (const InputError& error) {
    value.fail(error.what());
  }
}

}  // namespace rotatebook::scene
