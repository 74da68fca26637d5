#include "bridge/body_mesh.h"

#include <array>

#include "base/json.h"
#include "base/number_text.h"
#include "body/shape.h"
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
      return {.mesh = body::findShape("box")->solid({size.data(), 3}).surface};
    }
    takeMeshFile(*bytes, solid.mesh);
  }
  return scene::surfaceOf(solid);
}

std::string materialJson(const body::Material& material, const Eigen::Vector3d& size,
                         std::size_t first, std::size_t count) {
  const body::Grain& grain = material.grain;
  const auto list = [](const auto& numbers) {
    std::vector<std::string> texts;
    for (const auto number : numbers) texts.push_back(shortestText(static_cast<double>(number)));
    return jsonArray(texts);
  };
  return JsonObject()
      .addInteger("first", static_cast<std::int64_t>(first))
      .addInteger("count", static_cast<std::int64_t>(count))
      .add("baseColour", list(material.baseColour))
      .add("metalAndRoughness", list(std::array{material.metalness, material.roughness}))
      .add("grainsAcross", list(grainsAcross(grain, size)))
      .add("contrastAndRelief", list(std::array{grain.contrast, grain.relief}))
      .text();
}

/// Returns the vertices as 10 floats each.
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
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    const std::vector<std::uint32_t>& triangles = mesh.parts[i].triangles;
    if (triangles.empty()) continue;
    parts.push_back(materialJson(surface.materials[i], motion.body.size, made.indices.size(),
                                 triangles.size()));
    made.indices.insert(made.indices.end(), triangles.begin(), triangles.end());
  }
  made.json = JsonObject()
                  .addInteger("vertices", static_cast<std::int64_t>(mesh.vertices.size()))
                  .addInteger("indices", static_cast<std::int64_t>(made.indices.size()))
                  .add("parts", jsonArray(parts))
                  .text();
  return made;
}

}  // namespace rotatebook::bridge
