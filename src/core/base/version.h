// The program's version.
#pragma once

namespace rotatebook {

/// "MAJOR.MINOR.PATCH", the same as in CMakeLists.txt. Each source has its own copy: so the core
/// notices if a program was built with another version's headers.
constexpr const char* kVersion = "0.1.0";

}  // namespace rotatebook
