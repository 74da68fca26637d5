// The settings of a Renderer; other rooms have them by renderer.h. Inside the room only.
#pragma once

#include "base/rgb.h"
#include "geometry/book_mesh.h"
#include "geometry/camera.h"
#include "render/device/device.h"

namespace rotatebook::render {

/// Backgrounds behind the body.
enum class Background {
  Studio,       ///< A quiet, dark wall, brightest behind the book.
  Stars,        ///< A night sky.
  Transparent,  ///< Nothing: alpha is the pixel coverage of the body.
  Plain,        ///< RenderSettings::plainColour throughout.
};

/// Settings of a Renderer.
struct RenderSettings {
  int width = 1280;  ///< > 0 [pixels]
  int height = 720;  ///< > 0 [pixels]
  /// Factor, 1 or 2, by which the drawing is wider and higher than the picture, which takes the
  /// mean of its pixels in linear light.
  int supersample = 1;
  Background background = Background::Studio;
  Rgb plainColour{};  ///< For Background::Plain.
  /// Rows at the bottom that the camera's view leaves free. 0 to below `height`. [pixels]
  int bottomRows = 0;
  geometry::Camera camera;
  geometry::MeshDetail detail = geometry::MeshDetail::Full;  ///< Of the book.
  bool drawsBodies = true;  ///< Else pictures show the background alone.
  DeviceChoice device{};
};

}  // namespace rotatebook::render
