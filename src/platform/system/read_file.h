// A file's bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "system/file_descriptor.h"

namespace rotatebook::system {

/// Opens a file for reading. Throws InputError with nothing but the reason for what isn't there,
/// and for folders, devices and pipes, without waiting for them.
FileDescriptor openFile(const std::filesystem::path& path);

/// All bytes of `path`, a file of at most `most`. What is longer is refused without being read.
/// Throws InputError as openFile(), and MachineError "can't read `path`: CAUSE" if the disk fails.
std::string readFile(const std::filesystem::path& path, std::uintmax_t most);

/// All bytes of `path`; empty if it isn't there, isn't a file of at most `most` bytes, or can't be
/// read.
std::string readFileOrEmpty(const std::filesystem::path& path, std::uintmax_t most = 1 << 28);

}  // namespace rotatebook::system
