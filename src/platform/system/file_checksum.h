// The checksum of a file.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook::system {

/// Returns checksumOf() of a file's content. Throws MachineError if it doesn't exist, can't be read
/// or isn't a regular file.
std::string checksumOfFile(const std::filesystem::path& path);

}  // namespace rotatebook::system
