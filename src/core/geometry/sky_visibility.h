// Shadows that a body casts on itself. Inside the room only.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "geometry/mesh.h"

namespace rotatebook::geometry {

/// Finds each vertex's skyVisibility, by depth maps from all around: the share that no part of the
/// body hides, weighted by the cosine to the normal. The mesh is that of a box of `size` [m], of
/// closed surfaces, which may overlap; `places` are the numbers of its vertices' places, which
/// those of several sides share. Edges are halved where the share varies along them; what is drawn
/// stays the same but for it.
void addSkyVisibility(const Eigen::Vector3d& size, std::vector<std::uint32_t> places, Mesh& mesh);

}  // namespace rotatebook::geometry
