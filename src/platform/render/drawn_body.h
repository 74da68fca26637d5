// A body as OpenGL has drawn it.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "body/cuboid.h"
#include "geometry/hull_bands.h"
#include "image/image.h"
#include "render/antialias/strips.h"

namespace rotatebook::render {

/// A body drawn with one sample a pixel and nothing behind it, with what is needed to compose a
/// picture of it.
struct DrawnBody {
  std::size_t look = 0;  ///< Index of its look.
  image::Image pixels;   ///< Rgba8; alpha: MeshVertex::surfaceId, or 0 where nothing was drawn.
  std::vector<geometry::PixelRect> bands{};  ///< The valid areas of `pixels`. [pixels]
  body::Cage cage{};                         ///< World. [m]
  Eigen::Matrix4d clipFromWorld{};           ///< Clip y points down.
  int winding = 0;                           ///< From frontFaceWinding().
  DrawnStrips strips{};
  image::Image background{};  ///< Empty where it is the same in all pictures.
};

}  // namespace rotatebook::render
