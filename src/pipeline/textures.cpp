#include "pipeline/textures.h"

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "image/png_file.h"
#include "scene/places.h"

namespace rotatebook::pipeline {
namespace {

image::Image load(const scene::Scene& scene, std::string_view key, const std::string& file,
                  image::Image (*builtin)()) {
  if (file == scene::kBuiltin) return builtin();
  return scene::atPlaceOf(scene, key, [&] { return image::readPng(scene.folder / file); });
}

/// [degrees]
double verticalFieldOfView(const scene::Scene& scene, const render::Screen& screen) {
  const double angle = scene.camera.fieldOfViewDeg;
  const double height = screen.height - screen.bottomRows;
  if (scene.panels.empty() || screen.width >= height) return angle;
  // Panels have it over their shorter side.
  constexpr double kHalf = std::numbers::pi / 360;
  return std::atan(std::tan(angle * kHalf) * height / screen.width) / kHalf;
}

render::Background backgroundOf(scene::Background background) {
  switch (background) {
    case scene::Background::Stars:
      return render::Background::Stars;
    case scene::Background::Transparent:
      return render::Background::Transparent;
    case scene::Background::Studio:
      break;
  }
  return render::Background::Studio;
}

}  // namespace

void requireTextures(const scene::Scene& scene) {
  const scene::BookSettings& book = scene.book;
  for (const auto& [key, file] : {std::pair{"book.front", &book.front},
                                  {"book.spine", &book.spine},
                                  {"book.back", &book.back}}) {
    // The built-in ones are whole, and take a tenth of a render's start.
    if (*file != scene::kBuiltin) load(scene, key, *file, nullptr);
  }
}

render::BookTextures loadTextures(const scene::Scene& scene) {
  return {load(scene, "book.front", scene.book.front, render::builtinFront),
          load(scene, "book.spine", scene.book.spine, render::builtinSpine),
          load(scene, "book.back", scene.book.back, render::builtinBack)};
}

render::Camera cameraOf(const scene::Scene& scene, const render::Screen& screen) {
  return {scene.camera.position, scene.camera.target, scene.camera.up,
          verticalFieldOfView(scene, screen)};
}

render::Renderer makeRenderer(const scene::Scene& scene, const render::Screen& screen) {
  const render::BookTextures textures = loadTextures(scene);
  render::RenderSettings settings;
  settings.width = screen.width;
  settings.height = screen.height;
  settings.bottomRows = screen.bottomRows;
  settings.supersample = scene.look.supersample;
  settings.background = backgroundOf(scene.look.background);
  settings.camera = cameraOf(scene, screen);
  return {settings, textures};
}

render::Renderer makeRenderer(const scene::Scene& scene) {
  return makeRenderer(scene, {scene.clip.width, scene.clip.height, 0});
}

}  // namespace rotatebook::pipeline
