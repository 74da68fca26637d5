// The program's version.
#pragma once

namespace rotatebook {

/// "MAJOR.MINOR.PATCH", as CMakeLists.txt sets it.
extern const char* const kVersion;

}  // namespace rotatebook
