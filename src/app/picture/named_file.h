// The files that a scene names: textures, meshes, recordings, and the words of its pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace rotatebook::picture {

/// A file that a scene names.
struct NamedFile {
  std::filesystem::path path;
  std::string kind;  ///< "texture", "mesh", "recording" or "table of words".
};

/// Returns all files that the scene and its motions name, whether they exist or not. What is made
/// from the scene is made from them, too.
std::vector<NamedFile> namedFiles(const scene::Scene& scene);

/// Returns the path of `file`, which a scene in `folder` names. Throws InputError if it leads
/// outside the folder, by ".." or by links, and that isn't allowed.
std::filesystem::path pathOfNamedFile(const std::filesystem::path& folder,
                                      const std::filesystem::path& file, bool allowOutside);

}  // namespace rotatebook::picture
