// Reports of checkUp(), as text and as JSON.
#pragma once

#include <ostream>

#include "diagnose/checkup.h"

namespace rotatebook::diagnose {

/// Prints a table of the parts, each problem with its remedy, and a last line with the verdict.
void reportCheckup(const Checkup& checkup, std::ostream& out);

/// Prints the same as one JSON object. Unknown values are null.
void reportCheckupAsJson(const Checkup& checkup, std::ostream& out);

}  // namespace rotatebook::diagnose
