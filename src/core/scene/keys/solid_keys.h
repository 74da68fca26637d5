// The keys of [body] for what isn't the book. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "scene/keys/key.h"
#include "scene/solid.h"

namespace rotatebook::scene {

/// The keys, but for the mass, which the book has, too. `shape` and `dimensions` are read together,
/// by readStatedShape().
Keys<Solid> solidKeys();
/// The documentation of the keys of a part.
const std::vector<KeyRow>& partRows();

/// Returns the numbers of a mesh with its name, as TOML: motions, and a clip's record, take them in
/// place of the file.
std::string meshText(const MeshFile& mesh);

/// Reads the shape that `section`, [body], names, if it isn't the book, with its lengths and
/// density. Throws InputError.
void readStatedShape(const ValueReader& section, Solid& solid);

}  // namespace rotatebook::scene
