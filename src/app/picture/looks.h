// Loads what a scene's bodies look like, and makes its renderer.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/camera.h"
#include "picture/texture_files.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace rotatebook::picture {

/// The looks of a scene's bodies. The checksums are those of the bytes that are drawn, even if a
/// file changes.
struct LoadedLooks {
  std::vector<render::BodyLook> looks;  ///< Each once.
  std::vector<std::size_t> lookOf;      ///< By motion: its index in `looks`.
  TextureChecksums checksums;
};

/// Decodes the scene's textures, in parallel: the bytes of `files`, or else of the files
/// themselves. Throws as readTextures() does.
LoadedLooks loadLooks(const scene::Scene& scene, const TextureFiles& files = {});

/// Makes a renderer with the scene's settings and the given looks for `screen`.
render::Renderer makeRenderer(const scene::Scene& scene, const geometry::Screen& screen,
                              const std::vector<render::BodyLook>& looks,
                              const render::DeviceChoice& device = {});
/// Loads the scene's looks and makes a renderer for the whole picture.
render::Renderer makeRenderer(const scene::Scene& scene);

}  // namespace rotatebook::picture
