// Loads the pictures of a scene's book cover, and makes its camera and renderer.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// Replaces the checksum of a texture that ships with the program.
inline constexpr const char* kBuiltinTexture = "built-in";

/// The checksums of a scene's textures by key, like "book.front": checksumOf() the file's bytes, or
/// kBuiltinTexture.
using TextureChecksums = std::map<std::string, std::string>;

/// The bytes of a scene's texture files by key; built-in textures have none.
using TextureFiles = std::map<std::string, std::string>;

/// A scene's textures. The checksums are those of the bytes that are drawn, even if a file changes.
struct LoadedTextures {
  render::BookTextures pictures;
  TextureChecksums checksums;
};

/// Reads the texture files that the scene names. Throws InputError if one is missing or broken, or
/// leads outside the scene's folder without Scene::allowOutside.
TextureFiles readTextures(const scene::Scene& scene);
/// Decodes the scene's textures in parallel: the bytes of `files`, or else of the files themselves.
/// Throws as readTextures() does.
LoadedTextures loadTextures(const scene::Scene& scene, const TextureFiles& files = {});
/// Returns the texture files that the scene names, whether they exist or not.
std::vector<std::filesystem::path> textureFiles(const scene::Scene& scene);

/// Returns the scene's camera for `screen`, the whole picture or a panel.
render::Camera cameraOf(const scene::Scene& scene, const render::Screen& screen);

/// Makes a renderer with the scene's settings and the given textures for `screen`.
render::Renderer makeRenderer(const scene::Scene& scene, const render::Screen& screen,
                              const render::BookTextures& textures,
                              const render::DeviceChoice& device = {});
/// Loads the scene's textures and makes a renderer for the whole picture.
render::Renderer makeRenderer(const scene::Scene& scene);

}  // namespace rotatebook::picture
