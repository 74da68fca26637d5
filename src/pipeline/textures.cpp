#include "pipeline/textures.h"

#include "image/png_file.h"

namespace rotatebook::pipeline {
namespace {

image::Image load(const scene::Scene& scene, const std::string& file, image::Image (*builtin)()) {
  if (file == scene::kBuiltin) return builtin();
  return image::readPng(scene.folder / file);
}

}  // namespace

render::BookTextures loadTextures(const scene::Scene& scene) {
  return {load(scene, scene.book.front, render::builtinFront),
          load(scene, scene.book.spine, render::builtinSpine),
          load(scene, scene.book.back, render::builtinBack)};
}

render::Renderer makeRenderer(const scene::Scene& scene, int bottomRows) {
  const render::BookTextures textures = loadTextures(scene);
  render::RenderSettings settings;
  settings.width = scene.clip.width;
  settings.height = scene.clip.height;
  settings.bottomRows = bottomRows;
  settings.camera = {scene.camera.position, scene.camera.target, scene.camera.up,
                     scene.camera.fieldOfViewDeg};
  return {settings, textures};
}

}  // namespace rotatebook::pipeline
