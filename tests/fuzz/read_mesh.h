// A mesh in, which is refused or has triangles of points that are there.
#pragma once

#include "body/closed_surface.h"
#include "body/mass_properties.h"
#include "body/mesh_readers.h"
#include "fuzz/fuzzing.h"

namespace rotatebook::fuzzing {

inline void readMeshOrRefuse(const char* name, const std::uint8_t* bytes, std::size_t size) {
  mayRefuse([&] {
    const body::TriangleMesh mesh = body::readMesh(name, textOf(bytes, size));
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t point : triangle) require(point < mesh.points.size());
    body::requireClosed(mesh);
    require(body::massPropertiesOf(mesh, 1).volume > 0);
  });
}

}  // namespace rotatebook::fuzzing
