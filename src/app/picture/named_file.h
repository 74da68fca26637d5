// The files that a scene names: textures, meshes, recordings, and the words of its pictures.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace rotatebook::picture {

/// Returns the path of `file`, which a scene in `folder` names. Throws InputError if it leads
/// outside the folder, by ".." or by links, and that isn't allowed.
std::filesystem::path pathOfNamedFile(const std::filesystem::path& folder,
                                      const std::filesystem::path& file, bool allowOutside);

/// Returns the bytes of such a file, at most `most`. Throws InputError likewise, and if it can't be
/// read.
std::string readNamedFile(const std::filesystem::path& folder, const std::filesystem::path& file,
                          std::size_t most, bool allowOutside);

}  // namespace rotatebook::picture
