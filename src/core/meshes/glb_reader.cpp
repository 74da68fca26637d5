#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "base/error.h"
#include "base/text.h"
#include "body/surface.h"
#include "meshes/glb_document.h"
#include "meshes/glb_extensions.h"
#include "meshes/glb_materials.h"
#include "meshes/glb_numbers.h"
#include "meshes/glb_pose.h"
#include "meshes/glb_primitive.h"
#include "meshes/mesh_readers.h"
#include "meshes/polygon.h"

namespace rotatebook::meshes {
namespace {

using Json = GlbDocument::Json;
using Eigen::Matrix4d;

constexpr std::size_t kMaxParts = 100'000;  // nodes and their primitives, as often as they are used

/// The parts of a document that have no place in its surface.
struct LeftOut {
  std::size_t flat = 0;    ///< Primitives of points or lines.
  std::size_t hidden = 0;  ///< Nodes.
  std::vector<std::string> notes{};

  /// Adds a sentence that isn't there yet; of many that a file could ask for, the first ones.
  void note(const std::string& sentence) {
    constexpr std::size_t kMaxNotes = 8;
    if (sentence.empty() || std::ranges::find(notes, sentence) != notes.end()) return;
    if (notes.size() < kMaxNotes) notes.push_back(sentence);
    if (notes.size() == kMaxNotes) notes.back() = "more of its pictures aren't drawn as they are";
  }
};

/// Adds the triangles of a document's nodes, in their places, to a surface.
class Collector {
 public:
  Collector(const GlbDocument& document, body::Surface& surface)
      : document_(document), surface_(surface), skeletons_(document) {}

  void addNode(std::size_t index, const Matrix4d& parent, int depth) {
    if (depth > kMaxNodeDepth)
      throw InputError("its nodes are nested deeper than " + std::to_string(kMaxNodeDepth) +
                       ", or in each other; export it with its meshes joined");
    countPart();
    const Json& node = document_.at("nodes", index);
    if (GlbDocument::member(extensionOf(node, "KHR_node_visibility"), "visible") == false) {
      ++leftOut_.hidden;
      return;
    }
    const Matrix4d place = parent * placeOfNode(node);
    if (const auto mesh = GlbDocument::count(node, "mesh")) addMesh(node, *mesh, place);
    for (const Json& child : GlbDocument::member(node, "children")) {
      addNode(GlbDocument::wholeNumber(child, "a node's child"), place, depth + 1);
    }
  }

  std::vector<std::string> notes() {
    if (leftOut_.flat > 0) leftOut_.note("points and lines have no volume, and are left out");
    if (leftOut_.hidden > 0) leftOut_.note("nodes that the file hides are left out");
    return leftOut_.notes;
  }

 private:
  void countPart() {
    if (++parts_ <= kMaxParts) return;
    throw InputError("its nodes and primitives are more than " + std::to_string(kMaxParts) +
                     "; export it with its meshes joined");
  }

  void addMesh(const Json& node, std::size_t index, const Matrix4d& place) {
    if (!extensionOf(node, "EXT_mesh_gpu_instancing").is_null()) {
      throw InputError(
          "a node has copies of its mesh (EXT_mesh_gpu_instancing), which aren't read; export each "
          "as a node");
    }
    const Json& mesh = document_.at("meshes", index);
    const std::vector<double> weights = morphWeightsOf(node, mesh);
    for (const Json& primitive : GlbDocument::member(mesh, "primitives")) {
      countPart();
      const std::size_t mode = GlbDocument::count(primitive, "mode").value_or(kTriangleList);
      if (mode < kTriangleList) {
        ++leftOut_.flat;
        continue;
      }
      requireUncompressed(document_, primitive, "a mesh");
      requireRoom(primitive);
      std::vector<Eigen::Vector3d> points = positions_.of(primitive, weights);
      const bool isMirrored = putInPlace(node, primitive, place, points);
      const auto corners = cornersOf(document_, primitive, mode, points.size(), isMirrored);
      addTriangles(points, corners);
      addLook(primitive, corners, points.size());
    }
  }

  /// Throws InputError before there are more points than all triangles can have.
  void requireRoom(const Json& primitive) {
    const Json& attributes = GlbDocument::member(primitive, "attributes");
    const auto position = GlbDocument::count(attributes, "POSITION");
    if (!position) throw InputError("a mesh has no POSITION; export it again");
    const auto count = GlbDocument::count(document_.at("accessors", *position), "count");
    requireFewTriangles(surface_.mesh.points.size() / 3 + count.value_or(0) / 3);
  }

  /// Moves a node's points; returns whether that mirrors them.
  bool putInPlace(const Json& node, const Json& primitive, const Matrix4d& place,
                  std::vector<Eigen::Vector3d>& points) {
    // A skin's joints have places of their own, in place of the node's
    if (const auto skin = GlbDocument::count(node, "skin")) {
      return poseBySkin(document_, GlbDocument::member(primitive, "attributes"),
                        skeletons_.jointsOf(*skin), points);
    }
    for (Eigen::Vector3d& point : points) {
      const Eigen::Vector4d moved = place * Eigen::Vector4d(point.x(), point.y(), point.z(), 1);
      point = moved.head<3>();
    }
    return place.topLeftCorner<3, 3>().determinant() < 0;
  }

  void addTriangles(const std::vector<Eigen::Vector3d>& points,
                    const std::vector<std::uint32_t>& corners) {
    body::TriangleMesh& mesh = surface_.mesh;
    requireFewTriangles(mesh.triangles.size() + corners.size() / 3);
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), points.begin(), points.end());
    for (std::size_t i = 0; i < corners.size(); i += 3)
      mesh.triangles.push_back(
          {first + corners[i], first + corners[i + 1], first + corners[i + 2]});
  }

  void addLook(const Json& primitive, const std::vector<std::uint32_t>& corners,
               std::size_t points) {
    const std::size_t neutral = surface_.materials.size() - 1;
    const auto stated = GlbDocument::count(primitive, "material");
    if (stated) document_.at("materials", *stated);  // refuses one that isn't there
    const std::size_t material = std::min(stated.value_or(neutral), neutral);
    surface_.materialOf.resize(surface_.mesh.triangles.size(),
                               static_cast<std::uint32_t>(material));
    noteLook(primitive);
    if (!surface_.images.empty()) {
      const auto more = texCoordsOf(document_, primitive, corners, points);
      surface_.texCoords.insert(surface_.texCoords.end(), more.begin(), more.end());
    }
  }

  void noteLook(const Json& primitive) {
    const Json& attributes = GlbDocument::member(primitive, "attributes");
    if (!GlbDocument::member(attributes, "COLOR_0").is_null())
      leftOut_.note("its vertex colours aren't drawn");
    leftOut_.note(noteOnPictures(document_, primitive));
    for (const std::string& note : notesOnMaterial(document_, primitive)) leftOut_.note(note);
  }

  const GlbDocument& document_;
  body::Surface& surface_;
  GlbSkeletons skeletons_;
  GlbPositions positions_{document_};
  LeftOut leftOut_;
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

/// Adds the triangles of a document; returns notes on what was left out.
std::vector<std::string> collect(const GlbDocument& document, body::Surface& surface) {
  requireKnownExtensions(document);
  Collector collector(document, surface);
  for (const std::size_t root : rootsOf(document)) collector.addNode(root, Matrix4d::Identity(), 0);
  std::vector<std::string> notes = collector.notes();
  if (surface.mesh.triangles.empty() && !notes.empty())
    throw InputError("there are no triangles (" + joined(notes, "; ") +
                     "); export triangles that are shown");
  return notes;
}

}  // namespace

NotedSurface readGlb(std::string_view bytes) {
  const GlbDocument document(bytes);
  NotedSurface read;
  try {
    readMaterials(document, read.surface);
    read.notes = collect(document, read.surface);
  } catch (const InputError& error) {
    // A body moves as its triangles say, whatever it looks like
    read = {{}, {}, error.what()};
    read.notes = collect(document, read.surface);
  }
  return read;
}

}  // namespace rotatebook::meshes
