// What a command left, in words.
#pragma once

#include <string>
#include <vector>

namespace rotatebook::cli {

/// Prints "  wrote A, B and C", or that it is nothing.
void reportFiles(const std::vector<std::string>& things);

}  // namespace rotatebook::cli
