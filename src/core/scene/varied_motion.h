// Motions of a scene with other values of some keys. Inside the room only.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/document/value_reader.h"
#include "scene/axis.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Completes `axis`, read from `table`, by what `file` leaves to it. Throws InputError if its key
/// is none of a motion's sections; whether there is such a key shows when a value is read.
void finishAxis(const document::ValueReader& table, const document::ValueReader& file, Axis& axis);

/// Returns the key whose values an axis has: "initial.tilt.0" where they are angles of a tilt.
std::string variedKey(const Axis& axis);

/// Returns the models of motions.
std::vector<physics::Model> modelsOf(const std::vector<Panel>& motions);
/// Throws InputError at `location` if `key` changes none of the motions of `models`, which are
/// called "books" or "runs".
void refuseUnused(const std::string& location, const std::string& key,
                  const std::vector<physics::Model>& models, const std::string& motions);

/// An axis, or null for none, and the location of its key.
struct PlacedAxis {
  const Axis* axis;
  std::string location;

  std::size_t count() const { return axis != nullptr ? axis->values.size() : 1; }
};

/// Takes a motion with values of the axes, by their indices.
using TakeMotion = std::function<void(std::size_t outer, std::size_t inner, Motion)>;
/// Reads the motion of `file` with each value of the inner axis, for each one of the outer. Throws
/// InputError with the problems of all.
void readVaried(const document::ValueReader& file, const PlacedAxis& outer, const PlacedAxis& inner,
                const TakeMotion& take);

}  // namespace rotatebook::scene
