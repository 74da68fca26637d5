// Files that are installed with the program. Inside the room only.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace rotatebook::cli {

/// Returns the folder PREFIX of the program PREFIX/bin/rotatebook; empty if the system doesn't say.
std::filesystem::path programPrefix();

/// Returns PREFIX/share/rotatebook/NAME, or nothing if there is no such file.
std::optional<std::filesystem::path> installedFile(const std::string& name);

}  // namespace rotatebook::cli
