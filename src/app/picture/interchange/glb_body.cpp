#include "picture/interchange/glb_body.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "geometry/mesh.h"

namespace rotatebook::interchange {
namespace {

using Eigen::Vector3f;

int glbWrap(body::Wrap wrap) {
  constexpr int kRepeat = 10497, kClamp = 33071, kMirror = 33648;
  if (wrap == body::Wrap::Repeat) return kRepeat;
  return wrap == body::Wrap::Clamp ? kClamp : kMirror;
}

std::size_t addTexture(const ExportedPicture& picture, GlbFile& glb) {
  constexpr int kNearest = 9728, kLinear = 9729, kMipMaps = 9987;
  const std::size_t sampler =
      glb.add("samplers", {{"magFilter", picture.sampling.hasSquares ? kNearest : kLinear},
                           {"minFilter", kMipMaps},
                           {"wrapS", glbWrap(picture.sampling.across)},
                           {"wrapT", glbWrap(picture.sampling.down)}});
  return glb.add("textures", {{"sampler", sampler}, {"source", glb.addPicture(picture.bytes)}});
}

/// Adds a material; textures have the numbers of pictures.
std::size_t addMaterial(const ExportedMaterial& material, GlbFile& glb) {
  const Vector3f& colour = material.colour;
  Json numbered{{"baseColorFactor", {colour.x(), colour.y(), colour.z(), 1}},
                {"metallicFactor", material.metalness},
                {"roughnessFactor", material.roughness}};
  if (material.colourPicture) numbered["baseColorTexture"] = {{"index", *material.colourPicture}};
  if (material.metalPicture)
    numbered["metallicRoughnessTexture"] = {{"index", *material.metalPicture}};
  Json made{{"pbrMetallicRoughness", std::move(numbered)}};
  if (!material.name.empty()) made["name"] = material.name;
  return glb.add("materials", std::move(made));
}

template <typename Vector>
std::vector<float> numbersOf(const std::vector<Vector>& vectors) {
  std::vector<float> numbers;
  for (const Vector& vector : vectors) numbers.insert(numbers.end(), vector.begin(), vector.end());
  return numbers;
}

/// Returns coordinates whose v points down, as glTF's do.
std::vector<float> texCoordsOf(const ExportedPart& part) {
  std::vector<float> numbers;
  for (const Eigen::Vector2f& at : part.texCoords)
    numbers.insert(numbers.end(), {at.x(), 1 - at.y()});
  return numbers;
}

/// Returns the derivative of a corner's weight by the position in the unit cube.
Vector3f slopeOf(int corner, const Vector3f& at) {
  Vector3f slope;
  for (int axis = 0; axis < 3; ++axis) {
    slope[axis] = 1;
    for (int other = 0; other < 3; ++other) {
      const bool isHigh = (corner & (1 << other)) != 0;
      if (other == axis)
        slope[axis] *= isHigh ? 1.0F : -1.0F;
      else
        slope[axis] *= isHigh ? at[other] : 1 - at[other];
    }
  }
  return slope;
}

/// Adds the turning of normals by a corner that moves along an axis; returns their accessor.
std::size_t addNormals(const ExportedPart& part, const std::vector<Vector3f>& slopes, int axis,
                       GlbFile& glb) {
  constexpr float kSeen = 1e-3F;
  std::vector<std::uint32_t> places;
  std::vector<float> turns;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    // By the cofactors of I + e s^T, of the first order, across the normal: n' = -s n_e
    const Vector3f& normal = part.normals[i];
    const Vector3f turn = -normal[axis] * (slopes[i] - normal * normal.dot(slopes[i]));
    if (turn.norm() < kSeen) continue;
    places.push_back(static_cast<std::uint32_t>(i));
    turns.insert(turns.end(), turn.begin(), turn.end());
  }
  return glb.addSparse(places, turns, slopes.size());
}

/// Returns the morph targets of a part.
Json targetsOf(const ExportedPart& part, const Eigen::Vector3d& size, double reach, GlbFile& glb) {
  Json targets = Json::array();
  const auto unit = static_cast<float>(2 * reach);
  for (int corner = 0; corner < 8; ++corner) {
    std::vector<float> moved;
    std::vector<Vector3f> slopes;
    for (const Vector3f& position : part.positions) {
      const Vector3f at = position.cwiseQuotient(size.cast<float>()) + Vector3f::Constant(0.5F);
      moved.push_back(unit * static_cast<float>(geometry::trilinearWeights(at)[corner]));
      slopes.emplace_back(unit * slopeOf(corner, at).cwiseQuotient(size.cast<float>()));
    }
    const std::array<std::size_t, 3> positions = glb.addAlongAxes(moved);
    for (int axis = 0; axis < 3; ++axis)
      targets.push_back({{"POSITION", positions.at(static_cast<std::size_t>(axis))},
                         {"NORMAL", addNormals(part, slopes, axis, glb)}});
  }
  return targets;
}

Json primitiveOf(const ExportedPart& part, double reach, bool hasPictures, GlbFile& glb) {
  const std::size_t count = part.positions.size();
  std::vector<Vector3f> positions = part.positions;
  for (Vector3f& position : positions) position.array() -= static_cast<float>(reach);
  Json attributes{{"POSITION", glb.addFloats(numbersOf(positions), 3, Numbers::Ranged)},
                  {"NORMAL", glb.addFloats(numbersOf(part.normals), 3, Numbers::OfVertices)}};
  if (hasPictures)
    attributes["TEXCOORD_0"] = glb.addFloats(texCoordsOf(part), 2, Numbers::OfVertices);
  attributes["JOINTS_0"] = glb.addBytes({0, 0, 0, 0}, count, false);
  attributes["WEIGHTS_0"] = glb.addBytes({255, 0, 0, 0}, count, true);
  return {{"attributes", std::move(attributes)},
          {"indices", glb.addCorners(part.corners, count)},
          {"material", part.material}};
}

/// Returns "corner 0 x" and so on.
Json targetNames() {
  Json names = Json::array();
  for (int corner = 0; corner < 8; ++corner) {
    for (const char* axis : {" x", " y", " z"})
      names.push_back("corner " + std::to_string(corner) + axis);
  }
  return names;
}

}  // namespace

std::size_t addBody(const ExportedBody& body, std::optional<double> reach, GlbFile& glb) {
  for (const ExportedPicture& picture : body.pictures) addTexture(picture, glb);
  for (const ExportedMaterial& material : body.materials) addMaterial(material, glb);
  Json mesh{{"name", body.name}, {"primitives", Json::array()}};
  for (const ExportedPart& part : body.parts) {
    Json primitive = primitiveOf(part, reach.value_or(0), !body.pictures.empty(), glb);
    if (reach) primitive["targets"] = targetsOf(part, body.size, *reach, glb);
    mesh["primitives"].push_back(std::move(primitive));
  }
  if (reach) {
    mesh["extras"] = {{"targetNames", targetNames()}};
  }
  return glb.add("meshes", std::move(mesh));
}

}  // namespace rotatebook::interchange
