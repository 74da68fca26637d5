// A test of surfaces that take away: are they in others? Inside the room only.
#pragma once

#include <cstdint>
#include <span>

#include "body/triangle_mesh.h"

namespace rotatebook::body {

/// Throws InputError for a surface of a closed mesh that faces inward, so that it takes away, and
/// whose box is in no box of a surface that faces outward, naming one of its triangles. Surfaces
/// are those that share no point. `numbers` as for requireClosed().
void requireVoidsInside(const TriangleMesh& mesh, std::span<const std::uint32_t> numbers = {});

}  // namespace rotatebook::body
