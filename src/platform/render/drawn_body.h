// A body as it comes from OpenGL.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "image/image.h"
#include "physics/cuboid.h"
#include "render/antialias/hull_bands.h"
#include "render/antialias/strips.h"

namespace rotatebook::render {

/// A body drawn with one sample a pixel and nothing behind it, and what is needed to make a picture
/// of it.
struct DrawnBody {
  image::Image pixels;  ///< Rgba8; alpha: BookVertex::surfaceId, or 0 where nothing was drawn.
  std::vector<PixelRect> bands{};   ///< Where `pixels` are up to date. [pixels]
  physics::Cage cage{};             ///< World. [m]
  Eigen::Matrix4d clipFromWorld{};  ///< Clip y points down.
  int winding = 0;                  ///< windingOf()
  DrawnStrips strips{};
};

}  // namespace rotatebook::render
