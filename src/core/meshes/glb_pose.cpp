#include "meshes/glb_pose.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "base/error.h"
#include "meshes/glb_numbers.h"

namespace rotatebook::meshes {
namespace {

using Json = GlbDocument::Json;
using Eigen::Matrix4d;
using Eigen::Vector4d;

constexpr std::size_t kMaxJoints = 100'000;  // of all skins
constexpr std::uint32_t kNoParent = 0xffffffff;

/// Reads a list of exactly `values.size()` numbers; returns false if there is no such member.
template <std::size_t kCount>
bool readNumbers(const Json& node, const char* name, std::array<double, kCount>& values) {
  const Json& list = GlbDocument::member(node, name);
  if (list.is_null()) return false;
  bool isList = list.is_array() && list.size() == kCount;
  for (std::size_t i = 0; isList && i < kCount; ++i) {
    isList = list[i].is_number();
    if (isList) values[i] = list[i].template get<double>();
  }
  if (!isList) {
    throw InputError("a node's " + std::string(name) + " isn't a list of " +
                     std::to_string(kCount) + " numbers; export the file again");
  }
  return true;
}

/// The joints that move the points of a primitive, four a point, and their weights.
struct Influences {
  GlbNumbers joints, weights;
};

std::vector<Influences> influencesOf(const GlbDocument& document, const Json& attributes,
                                     std::size_t points) {
  constexpr std::size_t kMaxSets = 4;
  std::vector<Influences> sets;
  for (std::size_t i = 0;; ++i) {
    const std::string set = std::to_string(i);
    const auto joints = GlbDocument::count(attributes, ("JOINTS_" + set).c_str());
    const auto weights = GlbDocument::count(attributes, ("WEIGHTS_" + set).c_str());
    if (!joints || !weights) break;
    if (i == kMaxSets) throw InputError("points follow more than 16 joints each; export up to 16");
    sets.push_back(
        {{document, *joints, {"VEC4", 4, points}}, {document, *weights, {"VEC4", 4, points}}});
  }
  if (sets.empty()) {
    throw InputError(
        "a mesh with a skin has no JOINTS_0 and WEIGHTS_0, by which it follows its skeleton; "
        "export it in its pose, without a skeleton");
  }
  return sets;
}

}  // namespace

Matrix4d placeOfNode(const Json& node) {
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

Matrix4d GlbSkeletons::placeInScene(std::size_t node) {
  if (parents_.empty()) {
    parents_.resize(document_.size("nodes"), kNoParent);
    for (std::size_t i = 0; i < parents_.size(); ++i) {
      for (const Json& child : GlbDocument::member(document_.at("nodes", i), "children")) {
        const std::size_t number = GlbDocument::wholeNumber(child, "a node's child");
        if (number < parents_.size()) parents_[number] = static_cast<std::uint32_t>(i);
      }
    }
  }
  Matrix4d place = placeOfNode(document_.at("nodes", node));
  int depth = 0;
  for (std::uint32_t parent = parents_[node]; parent != kNoParent; parent = parents_[parent]) {
    if (++depth > kMaxNodeDepth)
      throw InputError("its nodes are nested deeper than " + std::to_string(kMaxNodeDepth) +
                       ", or in each other; export it with its meshes joined");
    place = placeOfNode(document_.at("nodes", parent)) * place;
  }
  return place;
}

const std::vector<Matrix4d>& GlbSkeletons::jointsOf(std::size_t skin) {
  const auto [found, isNew] = joints_.try_emplace(skin);
  std::vector<Matrix4d>& transforms = found->second;
  if (!isNew) return transforms;
  const Json& json = document_.at("skins", skin);
  const Json& joints = GlbDocument::member(json, "joints");
  count_ += joints.size();
  if (count_ > kMaxJoints) {
    throw InputError("its skins have more than " + std::to_string(kMaxJoints) +
                     " joints; export it in its pose, without skeletons");
  }
  std::optional<GlbNumbers> bindings;
  if (const auto accessor = GlbDocument::count(json, "inverseBindMatrices"))
    bindings.emplace(document_, *accessor, GlbNumbers::Wanted{"MAT4", 16});
  for (const Json& joint : joints) {
    Matrix4d unbound = Matrix4d::Identity();
    if (bindings && transforms.size() >= bindings->count())
      throw InputError("a skin has fewer inverseBindMatrices than joints; export it again");
    for (int i = 0; bindings && i < 16; ++i)
      unbound(i % 4, i / 4) = bindings->at(transforms.size(), static_cast<std::size_t>(i));
    transforms.push_back(placeInScene(GlbDocument::wholeNumber(joint, "a skin's joint")) * unbound);
  }
  return transforms;
}

bool poseBySkin(const GlbDocument& document, const Json& attributes,
                const std::vector<Matrix4d>& joints, std::vector<Eigen::Vector3d>& points) {
  const std::vector<Influences> sets = influencesOf(document, attributes, points.size());
  bool isMirrored = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Matrix4d sum = Matrix4d::Zero();
    double total = 0;
    for (const Influences& set : sets) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double weight = set.weights.at(i, k);
        if (weight == 0) continue;
        const std::uint32_t joint = set.joints.indexAt(i, k);
        if (joint >= joints.size()) {
          throw InputError("a point follows joint " + std::to_string(joint) +
                           " of a skin, counted from 0, but there are " +
                           std::to_string(joints.size()) + "; export the file again");
        }
        sum += weight * joints[joint];
        total += weight;
      }
    }
    if (!(total > 0)) throw InputError("a point of a mesh with a skin has no weights");
    if (i == 0) isMirrored = sum.topLeftCorner<3, 3>().determinant() < 0;
    points[i] = (sum * points[i].homogeneous()).head<3>() / total;
  }
  return isMirrored;
}

}  // namespace rotatebook::meshes
