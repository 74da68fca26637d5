#include "bridge/body_mesh.h"

#include <array>

#include "base/json.h"
#include "base/number_text.h"
#include "geometry/body_mesh.h"
#include "scene/solid_numbers.h"

namespace rotatebook::bridge {
namespace {

body::Surface surfaceOf(const scene::Motion& motion,
                        const std::function<const std::string*(const std::string&)>& fileOf) {
  scene::Solid solid = motion.solid;
  const std::string& name = solid.mesh.name;
  if (!name.empty() && solid.mesh.content == nullptr) {
    const std::string* bytes = fileOf(name);
    if (bytes == nullptr) {
      const Eigen::Vector3d& size = motion.body.size;
      return scene::surfaceOf(
          {.parts = {{.shape = "box", .lengths = {size.x(), size.y(), size.z()}}}});
    }
    takeMeshFile(*bytes, solid.mesh);
  }
  return scene::surfaceOf(solid);
}

Json materialJson(const body::Material& material, const Eigen::Vector3d& size, std::size_t first,
                  std::size_t count) {
  const body::Grain& grain = material.grain;
  return {{"first", first},
          {"count", count},
          {"baseColour", vectorJson(material.baseColour)},
          {"metalAndRoughness", std::array{material.metalness, material.roughness}},
          {"grainsAcross", vectorJson(grainsAcross(grain, size))},
          {"contrastAndRelief", std::array{grain.contrast, grain.relief}}};
}

/// Returns the vertices as 13 floats each.
std::vector<float> floatsOf(const std::vector<geometry::MeshVertex>& vertices) {
  std::vector<float> floats;
  const auto append = [&floats](const auto& vector) {
    floats.insert(floats.end(), vector.data(), vector.data() + vector.size());
  };
  for (const geometry::MeshVertex& vertex : vertices) {
    append(vertex.position);
    append(vertex.normal);
    append(vertex.texCoord);
    floats.push_back(vertex.skyVisibility);
    floats.push_back(vertex.surfaceId);
    append(vertex.away);
  }
  return floats;
}

BookMesh madeBook() {
  const geometry::Mesh mesh = geometry::makeBookMesh();
  BookMesh made{floatsOf(mesh.vertices), {}};
  for (std::size_t part = 0; part < made.indices.size(); ++part) {
    for (const std::uint32_t index : mesh.parts[part].triangles)
      made.indices[part].push_back(static_cast<std::uint16_t>(index));
  }
  return made;
}

}  // namespace

const BookMesh& bookMesh() {
  static const BookMesh made = madeBook();
  return made;
}

BodyMesh bodyMeshOf(const scene::Motion& motion,
                    const std::function<const std::string*(const std::string&)>& fileOf) {
  const body::Surface surface = surfaceOf(motion, fileOf);
  const geometry::Mesh mesh = geometry::makeBodyMesh(surface, motion.body.size);
  BodyMesh made{"", floatsOf(mesh.vertices), {}};
  Json parts = Json::array();
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    const std::vector<std::uint32_t>& triangles = mesh.parts[i].triangles;
    if (triangles.empty()) continue;
    parts.push_back(materialJson(surface.materials[i], motion.body.size, made.indices.size(),
                                 triangles.size()));
    made.indices.insert(made.indices.end(), triangles.begin(), triangles.end());
  }
  made.json = jsonText(
      {{"vertices", mesh.vertices.size()}, {"indices", made.indices.size()}, {"parts", parts}});
  return made;
}

}  // namespace rotatebook::bridge
