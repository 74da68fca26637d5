// The program's version.
#pragma once

namespace rotatebook {

/// "MAJOR.MINOR.PATCH", from CMakeLists.txt.
extern const char* const kVersion;

}  // namespace rotatebook
