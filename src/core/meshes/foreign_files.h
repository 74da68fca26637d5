// Files by their first bytes, whatever their names say. Inside the room only.
#pragma once

#include <string>
#include <string_view>

namespace rotatebook::meshes {

/// Returns whether a file has as many bytes as a binary STL's header says.
bool hasSizeOfStl(std::string_view bytes);

/// Returns what a file is, and the remedy, if it is known to be none of those whose names end so,
/// ".obj" for example: a sentence without its end. Empty if it may be one.
std::string otherKind(std::string_view ending, std::string_view bytes);

}  // namespace rotatebook::meshes
