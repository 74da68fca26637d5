// Reads files whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "system/file_descriptor.h"

namespace rotatebook::system {

/// The path of what is read from the standard input, and the name that it has.
inline constexpr const char* kStandardInput = "-";
inline constexpr const char* kNameOfInput = "stdin";

/// Returns `path`, or kNameOfInput for kStandardInput.
std::string nameOfInput(const std::string& path);

/// Opens a file for reading. Throws InputError, with the reason alone, if it doesn't exist or is a
/// folder, a device or a pipe, for which it doesn't wait.
FileDescriptor openFile(const std::filesystem::path& path);

/// Returns all bytes of `path`, a file of at most `limit` bytes. A longer one is refused without
/// being read. Throws InputError like openFile() or for a longer file, and MachineError "can't read
/// `path`: CAUSE" if the disk fails.
std::string readFile(const std::filesystem::path& path, std::uintmax_t limit);

/// Returns the same; of kStandardInput all that it has. Throws InputError with the reason alone,
/// also if that is nothing.
std::string readFileOrInput(const std::filesystem::path& path, std::uintmax_t limit);

/// Returns the same as readFile(). What it throws says, whatever failed, "can't read `path`: " and
/// the reason.
std::string readInput(const std::filesystem::path& path, std::uintmax_t limit);

/// Returns all bytes of `path`; empty if it doesn't exist, isn't a file of at most `limit` bytes,
/// or can't be read.
std::string readFileOrEmpty(const std::filesystem::path& path, std::uintmax_t limit = 1 << 28);

}  // namespace rotatebook::system
