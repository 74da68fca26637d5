// Any body's surface as a mesh to draw.
#pragma once

#include <Eigen/Core>

#include "body/surface.h"
#include "geometry/mesh.h"

namespace rotatebook::geometry {

/// Makes the mesh of a surface [m], around the centre of mass, in the unit cube of a box of that
/// size around the centre of mass. [m] Part i has the triangles of material i. Triangles that meet
/// along an edge at less than kCreaseDeg share its vertices, and are lit as one smooth surface;
/// normals are weighted by area. `surface.mesh` shares points, as body::welded() meshes do.
Mesh makeBodyMesh(const body::Surface& surface, const Eigen::Vector3d& size);

/// The least angle at which two triangles form an edge. [degrees]
inline constexpr double kCreaseDeg = 35;

}  // namespace rotatebook::geometry
