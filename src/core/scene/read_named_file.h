// Files that scenes name.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace rotatebook::scene {

/// Returns the text of a file that a scene names, relative to its folder. Throws InputError
/// "can't read FILE: CAUSE", also if it has more than `most` bytes.
using ReadNamedFile =
    std::function<std::string(const std::filesystem::path& file, std::size_t most)>;

/// Longest file of a mesh. [bytes]
inline constexpr std::size_t kLongestMesh = 256 << 20;

}  // namespace rotatebook::scene
