// The grain of metal and wood, for other programs. Inside the room only.
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "geometry/mesh.h"
#include "image/image.h"

namespace rotatebook::interchange {

inline constexpr int kGrainsOfTile = 20;  // Along each of its sides.

/// Returns a tile of the grain that surface.frag has, which repeats across and down: what
/// (1 + contrast) times the colour is multiplied by. `contrast`: [0 to 1]
image::Image grainTile(float contrast);

/// Returns the axis of the unit cube that a triangle faces most: its grain is that along the other
/// two. `corners`: its three vertices; `size`: of the box around the body.
int facedAxis(const geometry::Mesh& mesh, const std::uint32_t* corners,
              const Eigen::Vector3f& size);

/// Returns where a position in the unit cube is on tiles, of a side that faces an axis. `grains`:
/// along the edges of the cube.
Eigen::Vector2f placeOnTiles(const Eigen::Vector3f& position, int axis,
                             const Eigen::Vector3f& grains);

}  // namespace rotatebook::interchange
