// Reads typed and checked values of a TOML document, and names them in messages.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/document/toml_tree.h"
#include "base/error.h"
#include "base/units.h"

namespace rotatebook::document {

/// A range of finite numbers that a value may have, and its description in messages.
struct NumberRange {
  std::string_view expected;  ///< "a positive number"
  double min;                 ///< Smallest allowed number.
  double max;                 ///< Greatest allowed number.
  /// Of the values, which are in SI units then, or texts with a unit of their own.
  std::optional<Dimension> dimension{};
};

inline constexpr NumberRange kPositive{"a positive number",
                                       std::numeric_limits<double>::denorm_min(),
                                       std::numeric_limits<double>::max()};

inline constexpr NumberRange kPositiveTime{"a time over 0 s", kPositive.min, kPositive.max,
                                           Dimension::Time};

inline constexpr NumberRange kNumber{"a number", std::numeric_limits<double>::lowest(),
                                     std::numeric_limits<double>::max()};

// Descriptions of other allowed values in messages.
std::string expectedInteger(int min, int max);
std::string expectedString(std::size_t most);

class ValueReader;

/// A key that a table may have, and the function that reads its value.
struct Field {
  std::string_view key;
  std::function<void(const ValueReader&)> read;
};

/// Reads one value, which has a name such as "simulation.substeps". It refers to the tree, which
/// must outlive it. The members throw InputError "LOCATION: NAME must be EXPECTED, not FOUND" for a
/// value that isn't allowed.
class ValueReader {
 public:
  /// `name` is empty for the whole file.
  ValueReader(const TomlNode& node, std::string name) : node_(&node), name_(std::move(name)) {}

  const std::string& name() const { return name_; }
  const TomlNode& node() const { return *node_; }

  /// Returns a string of at most `most` characters that isOneLine().
  std::string text(std::size_t most) const;
  /// Returns a string likewise that may have tabs and line ends.
  std::string lines(std::size_t most) const;
  int integer(int min, int max) const;
  /// Returns a number, or the SI value of a text such as "1 deg" if the range has a dimension.
  /// Integers are numbers too; NaN and infinity are in no range.
  double number(const NumberRange& range) const;
  /// Returns the index of the string in `names`.
  std::size_t choice(std::span<const std::string_view> names) const;

  /// Returns the elements of an array of that length. They keep the array's name.
  std::vector<ValueReader> elements(std::size_t count, const std::string& expected) const;
  /// Returns the elements of a non-empty array. They keep the array's name.
  std::vector<ValueReader> list(const std::string& expected) const;
  /// Returns the tables of a non-empty array, or this value if it is a table.
  std::vector<ValueReader> tables(const std::string& expected) const;
  /// Reads a table, in the order of the text, and refuses keys that aren't among `fields`. Goes on
  /// after a problem, and throws all of them in the end.
  void readTable(const std::vector<Field>& fields) const;
  /// Returns the value of a key of this table, if it is present.
  std::optional<ValueReader> find(std::string_view key) const;
  /// Returns the value of a key in a section of this table, if both are present.
  std::optional<ValueReader> find(std::string_view section, std::string_view key) const;

  /// Throws InputError "LOCATION: NAME must be EXPECTED, not FOUND".
  [[noreturn]] void mismatch(const std::string& expected) const;
  /// Throws InputError "LOCATION: PROBLEM".
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  std::string nameOfKey(std::string_view key) const;
  [[noreturn]] void refuseKey(const TomlEntry& entry, const std::vector<Field>& fields) const;

  const TomlNode* node_;
  std::string name_;
};

/// Reads each of `values`, goes on after a problem, and throws all of them in the end.
void readEach(std::span<const ValueReader> values,
              const std::function<void(const ValueReader&)>& read);

/// Returns what `check` returns, and throws an InputError of it again with the location of `value`:
/// who checks knows the problem, but not the location.
template <typename Check>
auto failAtValue(const ValueReader& value, const Check& check) {
  try {
    return check();
  } catch (const InputError& error) {
    value.fail(error.what());
  }
}

}  // namespace rotatebook::document
