// Motions of a scene with other values of some keys. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "document/toml_tree.h"
#include "document/value_reader.h"
#include "scene/keys/sweep_values.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// A key, the reader of its name, and its values.
struct VariedKey {
  document::ValueReader key;
  std::vector<StatedValue> values;
};

/// Reads `over` and `values` of a table, which has both. Throws InputError if `over` is no key of a
/// motion's sections; whether there is such a key shows when a value is read.
VariedKey variedKeyFrom(const document::ValueReader& table);

/// Returns the models of motions.
std::vector<physics::Model> modelsOf(const std::vector<Panel>& motions);
/// Throws InputError at `place` if `key` changes none of the motions of `models`, which are called
/// "books" or "runs".
void refuseUnused(const document::ValueReader& place, const std::string& key,
                  const std::vector<physics::Model>& models, const std::string& motions);

/// Returns the sections that settle a motion, as far as `file` has them.
document::TomlNode motionPart(const document::ValueReader& file);

/// Puts a value of `key` at `path`, such as its own text, in `sections`, from motionPart(). Throws
/// InputError if the path leads nowhere.
void put(document::TomlNode& sections, const std::string& path, const VariedKey& key,
         const StatedValue& value);
void put(document::TomlNode& sections, const VariedKey& key, const StatedValue& value);

/// Reads and checks a motion with the time of `clock`, as takeClock() takes it, unless
/// `sections` state another. Throws
/// InputError.
Motion motionFrom(const document::TomlNode& sections, const physics::SimulationSettings& clock);

}  // namespace rotatebook::scene
