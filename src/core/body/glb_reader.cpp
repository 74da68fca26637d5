#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/text.h"
#include "body/mesh_readers.h"
#include "body/mesh_words.h"
#include "body/polygon.h"

namespace rotatebook::body {
namespace {

using Json = nlohmann::json;
using Eigen::Matrix4d;

constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kMaxDepth = 100;              // of nodes in nodes
constexpr std::size_t kMaxJson = 1 << 24;   // [bytes]
constexpr std::size_t kMaxNodes = 100'000;  // that are visited

/// The chunks of a file.
struct Chunks {
  std::string_view json, binary;
};

Chunks chunksOf(std::string_view bytes) {
  MeshBytes file(bytes);
  if (bytes.size() < 12 || file.next<std::uint32_t>() != kMagic)
    throw InputError("it doesn't begin with \"glTF\": not a .glb file");
  const auto version = file.next<std::uint32_t>();
  if (version != 2) {
    throw InputError("it is of glTF " + std::to_string(version) + "; export it as glTF 2.0");
  }
  file.next<std::uint32_t>();
  Chunks chunks;
  while (file.left() >= 8) {
    const auto length = file.next<std::uint32_t>();
    const auto kind = file.next<std::uint32_t>();
    const std::string_view chunk = file.take(length);
    if (kind == kJsonChunk && chunks.json.empty()) chunks.json = chunk;
    if (kind == kBinaryChunk && chunks.binary.empty()) chunks.binary = chunk;
  }
  if (chunks.json.empty() || chunks.json.size() > kMaxJson)
    throw InputError("it has no description in JSON, or one of more than 16 MiB");
  return chunks;
}

/// A glTF document, whose parts are found by number.
class Document {
 public:
  explicit Document(const Chunks& chunks)
      : json_(Json::parse(chunks.json, nullptr, false)), binary_(chunks.binary) {
    if (!json_.is_object()) throw InputError("its description isn't JSON; export it again");
    const Json& required = member(json_, "extensionsRequired");
    if (required.is_array() && !required.empty() && required[0].is_string()) {
      throw InputError("it needs the extension " +
                       quotedText(oneLine(required[0].get<std::string>(), 60)) +
                       ", which isn't read; export it without compression");
    }
  }

  /// Returns a member of an object; null if it has none.
  static const Json& member(const Json& json, const char* name) {
    static const Json kNull;
    const auto found = json.is_object() ? json.find(name) : json.end();
    return json.is_object() && found != json.end() ? *found : kNull;
  }
  /// Returns a whole number of at least 0; nothing if there is none. Throws for what isn't one.
  static std::optional<std::size_t> count(const Json& json, const char* name) {
    const Json& value = member(json, name);
    if (value.is_null()) return std::nullopt;
    if (!value.is_number_unsigned())
      throw InputError(std::string(name) + " isn't a whole number; export the file again");
    return value.get<std::size_t>();
  }

  std::size_t size(const char* list) const {
    const Json& all = member(json_, list);
    return all.is_array() ? all.size() : 0;
  }
  const Json& at(const char* list, std::size_t index) const {
    if (index >= size(list)) {
      throw InputError(std::string(list) + " has no number " + std::to_string(index) +
                       ", which is used; export the file again");
    }
    return member(json_, list)[index];
  }
  const Json& root() const { return json_; }

  /// The bytes of an accessor's numbers.
  struct Numbers {
    std::string_view bytes;
    std::size_t count, stride;
    std::size_t type;  ///< 5121, 5123, 5125 or 5126, of unsigned numbers of 1, 2, 4 bytes, floats
  };
  /// Returns the numbers of an accessor with so many components. Throws unless all are there.
  Numbers numbers(std::size_t accessor, std::string_view type, std::size_t components) const;

 private:
  Json json_;
  std::string_view binary_;
};

std::size_t sizeOfType(std::size_t type) {
  switch (type) {
    case 5121:
      return 1;
    case 5123:
      return 2;
    case 5125:
      return 4;
    case 5126:
      return 4;
    default:
      throw InputError("numbers of the type " + std::to_string(type) + " aren't read");
  }
}

Document::Numbers Document::numbers(std::size_t index, std::string_view type,
                                    std::size_t components) const {
  const Json& accessor = at("accessors", index);
  const std::string name = "accessor " + std::to_string(index);
  const Json& kind = member(accessor, "type");
  if (!kind.is_string() || kind.get<std::string>() != type)
    throw InputError(name + " isn't of the type " + std::string(type));
  if (!member(accessor, "sparse").is_null() || !count(accessor, "bufferView"))
    throw InputError(name + " is sparse, which isn't read; export the file without morphs");
  const Json& view = at("bufferViews", *count(accessor, "bufferView"));
  const Json& buffer = at("buffers", count(view, "buffer").value_or(0));
  if (!member(buffer, "uri").is_null())
    throw InputError("its data is in another file; export it as one .glb");

  Numbers numbers{{}, count(accessor, "count").value_or(0), 0, 0};
  numbers.type = count(accessor, "componentType").value_or(0);
  const std::size_t element = components * sizeOfType(numbers.type);
  numbers.stride = count(view, "byteStride").value_or(element);
  const std::size_t viewBegin = count(view, "byteOffset").value_or(0);
  const std::size_t viewSize = count(view, "byteLength").value_or(0);
  const std::size_t begin = count(accessor, "byteOffset").value_or(0);
  requireFewTriangles(numbers.count / 3);
  const bool isInView =
      viewBegin <= binary_.size() && viewSize <= binary_.size() - viewBegin && begin <= viewSize &&
      numbers.stride >= element && numbers.stride <= 252 + element &&
      (numbers.count == 0 || (element <= viewSize - begin &&
                              numbers.count - 1 <= (viewSize - begin - element) / numbers.stride));
  if (!isInView) throw InputError(name + " reaches beyond the file's data; is the file whole?");
  numbers.bytes = binary_.substr(viewBegin + begin, viewSize - begin);
  return numbers;
}

/// Returns the numbers of a list of exactly `values.size()`; false if there is no such member.
template <std::size_t kCount>
bool readNumbers(const Json& node, const char* name, std::array<double, kCount>& values) {
  const Json& list = Document::member(node, name);
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

/// Adds the triangles of a document's nodes, in their places, to a mesh.
class Collector {
 public:
  Collector(const Document& document, TriangleMesh& mesh) : document_(document), mesh_(mesh) {}

  void addNode(std::size_t index, const Matrix4d& parent, int depth) {
    if (depth > kMaxDepth || ++nodes_ > kMaxNodes) {
      throw InputError("its nodes are nested deeper than " + std::to_string(kMaxDepth) +
                       ", or are more than " + std::to_string(kMaxNodes));
    }
    const Json& node = document_.at("nodes", index);
    const Matrix4d place = parent * placeOf(node);
    if (const auto mesh = Document::count(node, "mesh")) addMesh(*mesh, place);
    for (const Json& child : Document::member(node, "children")) {
      if (!child.is_number_unsigned()) throw InputError("a node's child isn't a number");
      addNode(child.get<std::size_t>(), place, depth + 1);
    }
  }

 private:
  void addMesh(std::size_t index, const Matrix4d& place) {
    const Json& primitives = Document::member(document_.at("meshes", index), "primitives");
    for (const Json& primitive : primitives) {
      const std::size_t mode = Document::count(primitive, "mode").value_or(4);
      if (mode != 4) {
        throw InputError("mesh " + std::to_string(index) + " is of the mode " +
                         std::to_string(mode) + "; export lists of triangles (4)");
      }
      addTriangles(primitive, place);
    }
  }

  void addTriangles(const Json& primitive, const Matrix4d& place) {
    const auto position = Document::count(Document::member(primitive, "attributes"), "POSITION");
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
    addIndices(cornersOf(primitive, points.count), first, isMirrored);
  }

  /// Returns the indices of the corners, three a triangle.
  std::vector<std::uint32_t> cornersOf(const Json& primitive, std::size_t points) const {
    std::vector<std::uint32_t> corners;
    const auto accessor = Document::count(primitive, "indices");
    if (!accessor) {
      for (std::size_t i = 0; i < points; ++i) corners.push_back(static_cast<std::uint32_t>(i));
    } else {
      const auto numbers = document_.numbers(*accessor, "SCALAR", 1);
      for (std::size_t i = 0; i < numbers.count; ++i)
        corners.push_back(indexAt(numbers, i, points));
    }
    if (corners.size() % 3 != 0)
      throw InputError("a list of triangles has " + std::to_string(corners.size()) + " corners");
    return corners;
  }

  static std::uint32_t indexAt(const Document::Numbers& numbers, std::size_t i,
                               std::size_t points) {
    MeshBytes bytes(numbers.bytes.substr(i * numbers.stride));
    const std::uint32_t index = numbers.type == 5121   ? bytes.next<std::uint8_t>()
                                : numbers.type == 5123 ? bytes.next<std::uint16_t>()
                                                       : bytes.next<std::uint32_t>();
    if (numbers.type != 5126 && index < points) return index;
    throw InputError("triangle " + std::to_string(i / 3 + 1) + " of a mesh names point " +
                     std::to_string(index) + ", but there are " + std::to_string(points));
  }

  void addIndices(const std::vector<std::uint32_t>& corners, std::uint32_t first, bool isMirrored) {
    requireFewTriangles(mesh_.triangles.size() + corners.size() / 3);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const std::uint32_t a = first + corners[i], b = first + corners[i + 1],
                          c = first + corners[i + 2];
      mesh_.triangles.push_back({a, isMirrored ? c : b, isMirrored ? b : c});
    }
  }

  const Document& document_;
  TriangleMesh& mesh_;
  std::size_t nodes_ = 0;
};

/// Returns the numbers of the nodes that the file's scene shows; all roots where it has no scene.
std::vector<std::size_t> rootsOf(const Document& document) {
  std::vector<std::size_t> roots;
  if (document.size("scenes") > 0) {
    const std::size_t shown = Document::count(document.root(), "scene").value_or(0);
    for (const Json& node : Document::member(document.at("scenes", shown), "nodes")) {
      if (!node.is_number_unsigned()) throw InputError("a scene's node isn't a number");
      roots.push_back(node.get<std::size_t>());
    }
    return roots;
  }
  std::vector<bool> isChild(document.size("nodes"));
  for (std::size_t i = 0; i < isChild.size(); ++i) {
    for (const Json& child : Document::member(document.at("nodes", i), "children")) {
      if (child.is_number_unsigned() && child.get<std::size_t>() < isChild.size())
        isChild[child.get<std::size_t>()] = true;
    }
  }
  for (std::size_t i = 0; i < isChild.size(); ++i)
    if (!isChild[i]) roots.push_back(i);
  return roots;
}

}  // namespace

TriangleMesh readGlb(std::string_view bytes) {
  const Chunks chunks = chunksOf(bytes);
  const Document document(chunks);
  TriangleMesh mesh;
  Collector collector(document, mesh);
  for (const std::size_t root : rootsOf(document)) collector.addNode(root, Matrix4d::Identity(), 0);
  return mesh;
}

}  // namespace rotatebook::body
