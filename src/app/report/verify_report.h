// Reports on the verification of a clip, as text and as JSON.
#pragma once

#include <ostream>
#include <string>

#include "verify/verify_clip.h"

namespace rotatebook::report {

/// Prints what made the clip, a line for each check with what was measured beside its bound, and a
/// verdict. `clip` is the file's name.
void reportVerification(const std::string& clip, const verify::Verification& found,
                        std::ostream& out);

/// Prints the same as one JSON object on one line.
void reportVerificationAsJson(const std::string& clip, const verify::Verification& found,
                              std::ostream& out);

}  // namespace rotatebook::report
