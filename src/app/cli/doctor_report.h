// What was found of the machine, in words and for programs. Inside the room only.
#pragma once

#include <ostream>

#include "diagnose/checkup.h"

namespace rotatebook::cli {

/// A table of the parts, each problem with its remedy, and a last line with the verdict.
void reportCheckup(const diagnose::Checkup& checkup, std::ostream& out);

/// The same as one JSON object. What isn't known is null.
void reportCheckupAsJson(const diagnose::Checkup& checkup, std::ostream& out);

}  // namespace rotatebook::cli
