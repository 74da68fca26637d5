// The JSON Schema of scene files, by which editors complete and check them.
#pragma once

#include <string>

namespace rotatebook::scene {

/// Returns a schema as JSON on several lines, in draft 4 of JSON Schema (json-schema.org, the one
/// that TOML editors know) of the keys of allKeys(): types, limits, units, choices, defaults and
/// descriptions. What it refuses is no scene; what it takes may still be none, as checks across
/// keys aren't in it, nor the names that follow from others, such as those of a shape's lengths.
std::string sceneSchema();

}  // namespace rotatebook::scene
