// A scene's cover pictures.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// What a texture that ships with the program has in place of a checksum.
inline constexpr const char* kBuiltinTexture = "built-in";

/// What pictures were made of, by the scene's keys: kBuiltinTexture, or checksumOf() a file's
/// bytes.
using TextureChecksums = std::map<std::string, std::string>;

/// A scene's pictures, and of what they are: each file was read once, so that the checksums are of
/// the very bytes that are drawn, whatever becomes of the file.
struct LoadedTextures {
  render::BookTextures pictures;
  TextureChecksums checksums;
};

/// Reads the pictures that the scene names, all at once. Throws InputError for one that is missing
/// or broken, or that leads outside the scene's folder unless Scene::allowOutside.
LoadedTextures loadTextures(const scene::Scene& scene);
/// The files of pictures that the scene names, be they there or not.
std::vector<std::filesystem::path> textureFiles(const scene::Scene& scene);
/// Throws where loadTextures() would.
void requireTextures(const scene::Scene& scene);

/// The camera that draws the scene on `screen`: its whole picture, or a panel.
render::Camera cameraOf(const scene::Scene& scene, const render::Screen& screen);

/// One with the scene's camera, ready to draw on `screen`, by that device.
render::Renderer makeRenderer(const scene::Scene& scene, const render::Screen& screen,
                              const render::BookTextures& textures,
                              const render::DeviceChoice& device = {});
/// One with the scene's textures, too, ready to draw on the whole picture.
render::Renderer makeRenderer(const scene::Scene& scene);

}  // namespace rotatebook::picture
