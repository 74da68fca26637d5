// The keys of a scene file as data: the tables of docs/scene.md, units in
// margins, checks of what varies, fingerprints and the live book's controls follow from it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physics/motion_settings.h"
#include "scene/axis.h"
#include "scene/key_row.h"

namespace rotatebook::scene {

/// Returns all keys, section by section, those of each section in the order of messages.
const std::vector<KeyRow>& allKeys();

/// Returns the row of a key such as "body.size", of one in an array such as "nudge.0.at", or of the
/// one that a part such as "initial.tilt.0" is of; null if there is none.
const KeyRow* findKey(std::string_view key);

/// Returns why another value of `key` changes no motion of `models`; empty if it changes one.
std::string reasonForNoChange(std::string_view key, std::span<const physics::Model> models);

/// Returns a key with its unit, if it has one: "initial.tilt.0  [rad]".
std::string keyWithUnit(const std::string& key);
/// Returns the name beside an axis: its label, or its key, with the unit of numbers.
std::string nameOf(const Axis& axis);

/// Returns where a key of that name belongs: "under [body] or [clip]"; empty if nowhere.
std::string sectionsOf(std::string_view key);

}  // namespace rotatebook::scene
