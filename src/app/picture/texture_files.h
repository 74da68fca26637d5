// The files that a scene's textures come from.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace rotatebook::picture {

/// Replaces the checksum of a texture that ships with the program.
inline constexpr const char* kBuiltinTexture = "built-in";

/// The checksums of a scene's textures by key, like "book.front": checksumOf() the file's bytes, or
/// kBuiltinTexture.
using TextureChecksums = std::map<std::string, std::string>;

/// Returns the texture files that the scene names, whether they exist or not.
std::vector<std::filesystem::path> textureFiles(const scene::Scene& scene);
/// Throws whenever loadTextures() would.
void requireTextures(const scene::Scene& scene);

}  // namespace rotatebook::picture
