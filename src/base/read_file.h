// A file's bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace rotatebook {

/// All bytes of `path`, a file of at most `most`. What is longer is refused without being read;
/// folders, devices and pipes are, without being waited for. Throws InputError with nothing but the
/// reason, such as "No such file or directory".
std::string readFile(const std::filesystem::path& path, std::uintmax_t most);

/// All bytes of `path`; empty if it isn't there, isn't a file of at most `most` bytes, or can't be
/// read.
std::string readFileOrEmpty(const std::filesystem::path& path, std::uintmax_t most = 1 << 28);

}  // namespace rotatebook
