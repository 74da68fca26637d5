// The values that a sweep gives to a key. Inside the room only.
#pragma once

#include <vector>

#include "document/toml_tree.h"
#include "document/value_reader.h"
#include "scene/study_settings.h"

namespace rotatebook::scene {

/// A value, and the node that takes the place of the key's own.
struct StatedValue {
  SweepValue value;
  document::TomlNode node;
};

/// Reads a list of numbers, words and tables of a label and any value; or a range of numbers, which
/// are whole if both of its ends are. Throws InputError.
std::vector<StatedValue> statedValues(const document::ValueReader& values);

/// Returns the label of a number, a word, or true or false. Throws InputError.
std::string labelOf(const document::ValueReader& value);

}  // namespace rotatebook::scene
