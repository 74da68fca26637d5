// A file's bytes.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook {

/// All bytes of `path`; empty if it isn't there or can't be read.
std::string readFileOrEmpty(const std::filesystem::path& path);

}  // namespace rotatebook
