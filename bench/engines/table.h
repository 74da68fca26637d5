// The comparison in words and columns.
#pragma once

#include <vector>

#include "engines/engine.h"

namespace rotatebook::bench {

/// Runs every mode of every family at each length of step and prints a row for each to the standard
/// output. Throws rotatebook::Error if an engine does not take the book.
void printTable(const Motion& motion, const std::vector<Family>& families);

}  // namespace rotatebook::bench
