// What a command left, in words.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace rotatebook::cli {

/// Says "  wrote A, B and C", or that it is nothing.
void reportFiles(const std::vector<std::string>& things, std::ostream& out);

}  // namespace rotatebook::cli
