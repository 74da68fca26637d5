// --grid: a grid of books in one line. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "cli/shorthand.h"

namespace rotatebook::cli {

/// Returns overrides that give a scene the grid of `text`: "KEY=VALUES" or
/// "KEY=VALUES x KEY=VALUES", columns first. VALUES are "1,10,100", whole numbers "1..8", or a list
/// or a table as a scene has it. What the scene expects of its own motion is left out. Throws
/// InputError.
std::vector<Shorthand> gridShorthands(const std::string& text);

}  // namespace rotatebook::cli
