// The files that a scene names: textures, and the words of its pictures.
#pragma once

#include <filesystem>

namespace rotatebook::picture {

/// Returns the path of `file`, which a scene in `folder` names. Throws InputError if it leads
/// outside the folder, by ".." or by links, and that isn't allowed.
std::filesystem::path pathOfNamedFile(const std::filesystem::path& folder,
                                      const std::filesystem::path& file, bool allowOutside);

}  // namespace rotatebook::picture
