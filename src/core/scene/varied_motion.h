// Motions of a scene with other values of some keys. Inside the room only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/document/toml_tree.h"
#include "base/document/value_reader.h"
#include "scene/keys/axis_keys.h"
#include "scene/scene.h"
#include "scene/settled_motion.h"

namespace rotatebook::scene {

/// A key, the reader of its name, and its values.
struct VariedKey {
  document::ValueReader key;
  std::string path;  ///< The key, "initial.tilt.0" where the values are angles of a tilt.
  std::vector<StatedValue> values;
};

/// Reads an axis of values of `file`. Throws InputError if its key is none of a motion's sections;
/// whether there is such a key shows when a value is read.
VariedKey variedKeyFrom(const document::ValueReader& axis, const document::ValueReader& file);

/// Returns the models of motions.
std::vector<physics::Model> modelsOf(const std::vector<Panel>& motions);
/// Throws InputError at `place` if `key` changes none of the motions of `models`, which are called
/// "books" or "runs".
void refuseUnused(const document::ValueReader& place, const std::string& key,
                  const std::vector<physics::Model>& models, const std::string& motions);

/// Returns the sections that settle a motion, as far as `file` has them.
document::TomlNode motionPart(const document::ValueReader& file);

/// Puts a value of `key` into `sections`, from motionPart(). Throws InputError if its path leads
/// nowhere.
void put(document::TomlNode& sections, const VariedKey& key, const StatedValue& value);

/// Reads a value of a key of [body], [simulation], [initial] or [[nudge]] into a motion. Throws
/// InputError.
using ReadMotionKey = std::function<void(physics::MotionSettings&, const document::TomlNode&)>;
/// Returns what reads values of `key`, such as "body.mass", or of a part, such as "initial.tilt.0",
/// which `base` states. Throws InputError at `location` if there is no such key or part.
ReadMotionKey readerOf(const physics::MotionSettings& base, const std::string& key,
                       const std::string& location);

/// Motions that differ in the values of one key.
class VariedMotions {
 public:
  /// Takes what motionFrom() takes, without the key's values, and the key; they must outlive this.
  /// `known` is the motion of `sections` if that is at hand, or null.
  VariedMotions(const document::TomlNode& sections, Shared& shared, const VariedKey& key,
                const Motion* known = nullptr);

  /// Returns the motion with that value of the key. Throws InputError.
  Motion with(const StatedValue& value) const;

 private:
  const document::TomlNode& sections_;
  Shared& shared_;
  const VariedKey& key_;
  /// The motion without the values, where nothing but its start follows from them: its body, and
  /// what holds its particles together, is settled once.
  std::optional<Motion> base_{};
};

/// Reads, checks and settles a motion. Throws InputError.
Motion motionFrom(const document::TomlNode& sections, Shared& shared);

}  // namespace rotatebook::scene
