// A body as other programs take it: triangles, materials, pictures. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "body/surface.h"
#include "scene/scene.h"

namespace rotatebook::interchange {

/// A picture, and the way to read it.
struct ExportedPicture {
  std::string bytes;  ///< Of a PNG or JPEG.
  body::Sampling sampling{};

  bool isPng() const { return bytes.starts_with("\x89PNG"); }
};

/// A material of the metallic-roughness model; pictures, by their index, multiply its numbers.
struct ExportedMaterial {
  std::string name{};                  ///< None of other bodies' materials.
  Eigen::Vector3f colour{1, 1, 1};     ///< Linear. [0 to 1]
  float metalness = 0, roughness = 0;  ///< [0 to 1]
  std::optional<std::size_t> colourPicture{};
  std::optional<std::size_t> metalPicture{};  ///< Green multiplies roughness, blue metalness.
};

/// Triangles of one material.
struct ExportedPart {
  std::size_t material = 0;
  std::vector<std::uint32_t> corners{};  ///< Three vertices each, counter-clockwise from outside.
  std::vector<Eigen::Vector3f> positions{};  ///< Around the centre of mass. [m]
  std::vector<Eigen::Vector3f> normals{};    ///< Outward, of unit length.
  std::vector<Eigen::Vector2f> texCoords{};  ///< v points up.
};

/// A body around its centre of mass.
struct ExportedBody {
  std::string name;      ///< "book" or "body".
  Eigen::Vector3d size;  ///< Of the box around it. [m]
  std::vector<ExportedPicture> pictures{};
  std::vector<ExportedMaterial> materials{};  ///< Each has a part or more.
  std::vector<ExportedPart> parts{};          ///< One or more.
};

/// Returns the body of the scene's only motion. Throws as picture::loadLooks() does.
ExportedBody exportedBody(const scene::Scene& scene);

}  // namespace rotatebook::interchange
