// A mesh in, which is refused or is the surface of a body, with materials that are there.
#pragma once

#include "body/closed_surface.h"
#include "body/mass_properties.h"
#include "body/self_crossing.h"
#include "body/shells.h"
#include "fuzz/fuzzing.h"
#include "meshes/mesh_readers.h"

namespace rotatebook::fuzzing {

inline void requireLook(const body::Surface& surface) {
  const std::size_t count = surface.mesh.triangles.size();
  const auto isForEach = [&](std::size_t rows) { return rows == 0 || rows == count; };
  require(isForEach(surface.materialOf.size()) && isForEach(surface.texCoords.size()));
  require(!surface.materials.empty());
  for (const std::uint32_t material : surface.materialOf)
    require(material < surface.materials.size());
  for (const body::Material& material : surface.materials) {
    for (const int image : {material.baseColourImage, material.metalRoughnessImage})
      require(image < static_cast<int>(surface.images.size()));
  }
}

inline void readMeshOrRefuse(const char* name, const std::uint8_t* bytes, std::size_t size) {
  mayRefuse([&] {
    const body::Surface surface = meshes::readMesh(name, textOf(bytes, size)).surface;
    const body::TriangleMesh& mesh = surface.mesh;
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t point : triangle) require(point < mesh.points.size());
    require(body::isClosed(mesh));
    require(body::shellsOf(mesh).count > 0);
    require(body::massPropertiesOf(mesh, 1).volume > 0);
    body::findSelfCrossing(mesh);
    requireLook(surface);
  });
}

}  // namespace rotatebook::fuzzing
