#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/text.h"
#include "body/glb_document.h"
#include "body/glb_materials.h"
#include "body/mesh_readers.h"
#include "body/mesh_words.h"
#include "body/polygon.h"
#include "body/surface.h"

namespace rotatebook::body {
namespace {

using Json = GlbDocument::Json;
using Eigen::Matrix4d;

constexpr int kMaxDepth = 100;              // of nodes in nodes
constexpr std::size_t kMaxParts = 100'000;  // nodes and their primitives, as often as they are used

/// Returns the numbers of a list of exactly `values.size()`; false if there is no such member.
template <std::size_t kCount>
bool readNumbers(const Json& node, const char* name, std::array<double, kCount>& values) {
  const Json& list = GlbDocument::member(node, name);
  if (list.is_null()) return false;
  bool isList = list.is_array() && list.size() == kCount;
  for (std::size_t i = 0; isList && i < kCount; ++i) {
    isList = list[i].is_number();
    if (isList) values[i] = list[i].get<double>();
  }
  if (!isList) {
    throw InputError("a node's " + std::string(name) + " isn't a list of " +
                     std::to_string(kCount) + " numbers");
  }
  return true;
}

Matrix4d placeOf(const Json& node) {
  std::array<double, 16> matrix;
  if (readNumbers(node, "matrix", matrix)) return Matrix4d(matrix.data());  // By columns
  std::array<double, 3> move{0, 0, 0}, scale{1, 1, 1};
  std::array<double, 4> turn{0, 0, 0, 1};
  readNumbers(node, "translation", move);
  readNumbers(node, "rotation", turn);
  readNumbers(node, "scale", scale);
  const Eigen::Quaterniond rotation(turn[3], turn[0], turn[1], turn[2]);
  Matrix4d place = Matrix4d::Identity();
  place.topLeftCorner<3, 3>() = rotation.normalized().toRotationMatrix() *
                                Eigen::Vector3d(scale[0], scale[1], scale[2]).asDiagonal();
  place.topRightCorner<3, 1>() = Eigen::Vector3d(move[0], move[1], move[2]);
  return place;
}

/// Adds the triangles of a document's nodes, in their places, to a surface.
class Collector {
 public:
  Collector(const GlbDocument& document, Surface& surface)
      : document_(document), surface_(surface), mesh_(surface.mesh) {}

  void addNode(std::size_t index, const Matrix4d& parent, int depth) {
    if (depth > kMaxDepth)
      throw InputError("its nodes are nested deeper than " + std::to_string(kMaxDepth));
    countPart();
    const Json& node = document_.at("nodes", index);
    const Matrix4d place = parent * placeOf(node);
    if (const auto mesh = GlbDocument::count(node, "mesh")) addMesh(*mesh, place);
    for (const Json& child : GlbDocument::member(node, "children")) {
      addNode(GlbDocument::wholeNumber(child, "a node's child"), place, depth + 1);
    }
  }

 private:
  void countPart() {
    if (++parts_ <= kMaxParts) return;
    throw InputError("its nodes and primitives are more than " + std::to_string(kMaxParts) +
                     "; export it with its meshes joined");
  }

  void addMesh(std::size_t index, const Matrix4d& place) {
    const Json& primitives = GlbDocument::member(document_.at("meshes", index), "primitives");
    for (const Json& primitive : primitives) {
      countPart();
      const std::size_t mode = GlbDocument::count(primitive, "mode").value_or(4);
      if (mode != 4) {
        throw InputError("mesh " + std::to_string(index) + " is of the mode " +
                         std::to_string(mode) + "; export lists of triangles (4)");
      }
      addTriangles(primitive, place);
    }
  }

  void addTriangles(const Json& primitive, const Matrix4d& place) {
    const auto position =
        GlbDocument::count(GlbDocument::member(primitive, "attributes"), "POSITION");
    if (!position) throw InputError("a mesh has no POSITION; export it again");
    const auto points = document_.numbers(*position, "VEC3", 3);
    if (points.type != 5126)
      throw InputError("positions must be floats; export without quantising");
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    requireFewTriangles(mesh_.points.size() / 3 + points.count / 3);
    for (std::size_t i = 0; i < points.count; ++i) {
      MeshBytes bytes(points.bytes.substr(i * points.stride));
      Eigen::Vector4d point(0, 0, 0, 1);
      for (int axis = 0; axis < 3; ++axis) point[axis] = static_cast<double>(bytes.next<float>());
      mesh_.points.emplace_back((place * point).head<3>());
    }
    const bool isMirrored = place.topLeftCorner<3, 3>().determinant() < 0;
    const std::vector<std::uint32_t> corners = cornersOf(primitive, points.count, isMirrored);
    addIndices(corners, first);
    const std::size_t neutral = surface_.materials.size() - 1;
    const auto stated = GlbDocument::count(primitive, "material");
    if (stated) document_.at("materials", *stated);  // refuses one that isn't there
    const std::size_t material = stated.value_or(neutral);
    surface_.materialOf.resize(mesh_.triangles.size(),
                               static_cast<std::uint32_t>(std::min(material, neutral)));
    if (!surface_.images.empty()) addTexCoords(primitive, corners, points.count);
  }

  void addTexCoords(const Json& primitive, const std::vector<std::uint32_t>& corners,
                    std::size_t points) {
    std::vector<Eigen::Vector2f> all(points, Eigen::Vector2f::Zero());
    const Json& attributes = GlbDocument::member(primitive, "attributes");
    if (const auto accessor = GlbDocument::count(attributes, "TEXCOORD_0")) {
      const auto numbers = document_.numbers(*accessor, "VEC2", 2);
      if (numbers.type != 5126 || numbers.count != points)
        throw InputError("texture coordinates must be floats, one pair a position");
      for (std::size_t i = 0; i < points; ++i) {
        MeshBytes bytes(numbers.bytes.substr(i * numbers.stride));
        for (float& number : all[i]) number = bytes.next<float>();
      }
    }
    for (std::size_t i = 0; i < corners.size(); i += 3)
      surface_.texCoords.push_back({all[corners[i]], all[corners[i + 1]], all[corners[i + 2]]});
  }

  /// Returns the indices of the corners, three a triangle, counter-clockwise from outside.
  std::vector<std::uint32_t> cornersOf(const Json& primitive, std::size_t points,
                                       bool isMirrored) const {
    std::vector<std::uint32_t> corners;
    const auto accessor = GlbDocument::count(primitive, "indices");
    if (!accessor) {
      for (std::size_t i = 0; i < points; ++i) corners.push_back(static_cast<std::uint32_t>(i));
    } else {
      const auto numbers = document_.numbers(*accessor, "SCALAR", 1);
      for (std::size_t i = 0; i < numbers.count; ++i)
        corners.push_back(indexAt(numbers, i, points));
    }
    if (corners.size() % 3 != 0)
      throw InputError("a list of triangles has " + std::to_string(corners.size()) + " corners");
    for (std::size_t i = 0; isMirrored && i < corners.size(); i += 3)
      std::swap(corners[i + 1], corners[i + 2]);
    return corners;
  }

  static std::uint32_t indexAt(const GlbDocument::Numbers& numbers, std::size_t i,
                               std::size_t points) {
    MeshBytes bytes(numbers.bytes.substr(i * numbers.stride));
    const std::uint32_t index = numbers.type == 5121   ? bytes.next<std::uint8_t>()
                                : numbers.type == 5123 ? bytes.next<std::uint16_t>()
                                                       : bytes.next<std::uint32_t>();
    if (numbers.type != 5126 && index < points) return index;
    throw InputError("triangle " + std::to_string(i / 3 + 1) + " of a mesh names point " +
                     std::to_string(index) + ", but there are " + std::to_string(points));
  }

  void addIndices(const std::vector<std::uint32_t>& corners, std::uint32_t first) {
    requireFewTriangles(mesh_.triangles.size() + corners.size() / 3);
    for (std::size_t i = 0; i < corners.size(); i += 3)
      mesh_.triangles.push_back(
          {first + corners[i], first + corners[i + 1], first + corners[i + 2]});
  }

  const GlbDocument& document_;
  Surface& surface_;
  TriangleMesh& mesh_;
  std::size_t parts_ = 0;
};

/// Returns the numbers of the nodes that the file's scene shows; all roots where it has no scene.
std::vector<std::size_t> rootsOf(const GlbDocument& document) {
  std::vector<std::size_t> roots;
  if (document.size("scenes") > 0) {
    const std::size_t shown = GlbDocument::count(document.root(), "scene").value_or(0);
    for (const Json& node : GlbDocument::member(document.at("scenes", shown), "nodes"))
      roots.push_back(GlbDocument::wholeNumber(node, "a scene's node"));
    return roots;
  }
  std::vector<bool> isChild(document.size("nodes"));
  for (std::size_t i = 0; i < isChild.size(); ++i) {
    for (const Json& child : GlbDocument::member(document.at("nodes", i), "children")) {
      const std::size_t number = GlbDocument::wholeNumber(child, "a node's child");
      if (number < isChild.size()) isChild[number] = true;
    }
  }
  for (std::size_t i = 0; i < isChild.size(); ++i)
    if (!isChild[i]) roots.push_back(i);
  return roots;
}

void collect(const GlbDocument& document, Surface& surface) {
  Collector collector(document, surface);
  for (const std::size_t root : rootsOf(document)) collector.addNode(root, Matrix4d::Identity(), 0);
}

}  // namespace

TriangleMesh readGlb(std::string_view bytes) {
  Surface surface;
  collect(GlbDocument(bytes), surface);
  return surface.mesh;
}

Surface readGlbSurface(std::string_view bytes) {
  const GlbDocument document(bytes);
  Surface surface;
  readMaterials(document, surface);
  collect(document, surface);
  return surface;
}

}  // namespace rotatebook::body
