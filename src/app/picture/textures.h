// Loads the pictures of a scene's book cover, and makes its renderer.
#pragma once

#include "geometry/camera.h"
#include "picture/texture_files.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// A scene's textures. The checksums are those of the bytes that are drawn, even if a file changes.
struct LoadedTextures {
  render::BookTextures pictures;
  TextureChecksums checksums;
};

/// Decodes the scene's textures in parallel: the bytes of `files`, or else of the files themselves.
/// Throws as readTextures() does.
LoadedTextures loadTextures(const scene::Scene& scene, const TextureFiles& files = {});

/// Makes a renderer with the scene's settings and the given textures for `screen`.
render::Renderer makeRenderer(const scene::Scene& scene, const geometry::Screen& screen,
                              const render::BookTextures& textures,
                              const render::DeviceChoice& device = {});
/// Loads the scene's textures and makes a renderer for the whole picture.
render::Renderer makeRenderer(const scene::Scene& scene);

}  // namespace rotatebook::picture
