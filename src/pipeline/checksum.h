// Checksums that show whether a file is as it was written.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rotatebook::pipeline {

/// XXH3 of 128 bits as 32 hexadecimal digits, as xxh128sum prints it. It finds damage, not forgery.
std::string checksumOf(std::string_view bytes);

/// That of a file's content; of nothing if it isn't there or can't be read.
std::string checksumOfFile(const std::filesystem::path& path);

}  // namespace rotatebook::pipeline
