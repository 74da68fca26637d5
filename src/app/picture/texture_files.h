// The files that a scene's textures and meshes come from.
#pragma once

#include <map>
#include <string>

#include "scene/scene.h"

namespace rotatebook::picture {

/// Replaces the checksum of a texture that ships with the program.
inline constexpr const char* kBuiltinTexture = "built-in";

/// The checksums of a scene's textures and meshes by key, like "book.front", "body.mesh" or
/// "panel.1.body.mesh": checksumOf() the file's bytes, or kBuiltinTexture.
using TextureChecksums = std::map<std::string, std::string>;

/// The bytes of a scene's texture files by key; what is built in has none.
using TextureFiles = std::map<std::string, std::string>;

/// Reads the texture files that the scene names, whose meshes were read. Throws InputError if one
/// is missing or broken, or leads outside the scene's folder without Scene::allowOutside; and for a
/// mesh that scene::surfaceOf() refuses, or whose pictures are broken.
TextureFiles readTextures(const scene::Scene& scene);

/// Returns the checksums of the textures in `files` and of the scene's meshes.
TextureChecksums checksumsOf(const scene::Scene& scene, const TextureFiles& files);

}  // namespace rotatebook::picture
