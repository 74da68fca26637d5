// What was found of a clip, in words and as JSON. Inside the room only.
#pragma once

#include <ostream>
#include <string>

#include "verify/verify_clip.h"

namespace rotatebook::cli {

/// What made the clip, a line for each check with what was measured beside its bound, and a
/// verdict. `clip` is the file's name.
void reportVerification(const std::string& clip, const verify::Verification& found,
                        std::ostream& out);

/// The same as one JSON object in one line.
void reportVerificationAsJson(const std::string& clip, const verify::Verification& found,
                              std::ostream& out);

}  // namespace rotatebook::cli
