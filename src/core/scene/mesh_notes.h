// Notes on the files of meshes.
#pragma once

#include <string>
#include <vector>

#include "scene/solid.h"

namespace rotatebook::scene {

/// Returns sentences on what reading a solid's mesh has changed or left out, with the file's name;
/// none of other bodies, and where the file wasn't read.
std::vector<std::string> meshNotes(const Solid& solid);

}  // namespace rotatebook::scene
