// A scene's cover pictures.
#pragma once

#include "render/renderer.h"
#include "scene/scene.h"

namespace rotatebook::pipeline {

/// Reads the pictures that the scene names. Throws InputError for one that is missing or broken.
render::BookTextures loadTextures(const scene::Scene& scene);

/// The scene's picture size, camera and textures, ready to draw; `bottomRows` as RenderSettings.
render::Renderer makeRenderer(const scene::Scene& scene, int bottomRows = 0);

}  // namespace rotatebook::pipeline
