// Readings that a table holds for several rows. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "recording/gyroscope.h"

namespace rotatebook::recording {

/// Leaves out rates that repeat the one before, where a table has more rows than its gyroscope has
/// readings, or some are missing: a turning body's rates stand in up to 100 rows each, and a tenth
/// of them or more repeats the row before. At rest, where values may be the same by chance, one is
/// kept for each such number of rows. Returns a sentence on what is left out; empty for nothing.
std::string dropHeldReadings(std::vector<Rate>& rates);

}  // namespace rotatebook::recording
