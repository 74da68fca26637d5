// The checksum of a file.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook::system {

/// checksumOf() a file's content. Throws MachineError if it can't be read, isn't there or isn't a
/// file.
std::string checksumOfFile(const std::filesystem::path& path);

}  // namespace rotatebook::system
