// A body that isn't the book, as it looks.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "body/surface.h"
#include "image/image.h"

namespace rotatebook::render {

/// A body's surface, with its pictures decoded.
struct SurfaceLook {
  body::Surface surface;               ///< Around the centre of mass, along the body's axes. [m]
  Eigen::Vector3d size{1, 1, 1};       ///< Of the box around it, with its centre there. [m]
  std::vector<image::Image> images{};  ///< One for each of surface.images.
};

}  // namespace rotatebook::render
