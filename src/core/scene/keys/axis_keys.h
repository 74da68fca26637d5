// Reads and prints axes of variation. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "scene/axis.h"
#include "scene/keys/kinds.h"

namespace rotatebook::scene {

/// Reads an axis of values: of numbers, words and tables of a label and any value; or of a range of
/// numbers, which are whole if both of its ends are. Throws InputError.
Axis valueAxisFrom(const ValueReader& table);
std::string valueAxisText(const Axis& axis);
Axis pixelAxisFrom(const ValueReader& table);
std::string pixelAxisText(const Axis& axis);

std::vector<KeyRow> valueAxisRows();
std::vector<KeyRow> pixelAxisRows();

/// Axes of values, of [grid] and [study], as a list or as a range with its count.
template <auto kMember>
constexpr auto valueAxis(std::string_view name, const KeyText& documentation) {
  return key<kMember, valueAxisFrom, valueAxisText>(
      name,
      tableForm(kTableKind,
                "a table such as { key = \"simulation.substeps\", values = [1, 10, 100] }",
                valueAxisRows),
      documentation);
}

/// Axes of [map], whose range has a value for each pixel.
template <auto kMember>
constexpr auto pixelAxis(std::string_view name, const KeyText& documentation) {
  return key<kMember, pixelAxisFrom, pixelAxisText>(
      name,
      tableForm(kTableKind,
                "a table such as { key = \"simulation.substeps\", from = 1, to = 100, scale = "
                "\"log\" }",
                pixelAxisRows),
      documentation);
}

/// The form of what labelOf() reads.
inline constexpr ValueForm kLabelForm{.expected = "a number or a word",
                                      .kinds = {.text = true, .number = true, .flag = true}};
/// Returns the label of a number, a word, or true or false. Throws InputError.
std::string labelOf(const ValueReader& value);

/// Throws InputError unless `table` has all of the keys.
void requireKeys(const ValueReader& table, std::initializer_list<const char*> keys);

}  // namespace rotatebook::scene
