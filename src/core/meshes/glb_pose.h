// The places where the nodes and skeletons of a .glb file put its meshes. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "meshes/glb_document.h"

namespace rotatebook::meshes {

inline constexpr int kMaxNodeDepth = 100;  ///< Of nodes in nodes.

/// Returns the transform of a node into its parent. Throws InputError for what isn't numbers.
Eigen::Matrix4d placeOfNode(const GlbDocument::Json& node);

/// The skeletons of a document, as its nodes pose them.
class GlbSkeletons {
 public:
  explicit GlbSkeletons(const GlbDocument& document) : document_(document) {}

  /// Returns the transforms of a skin's joints, from where a mesh is bound to where it is shown.
  /// Throws InputError for a skin or joints that aren't there, or more joints than nodes may be.
  const std::vector<Eigen::Matrix4d>& jointsOf(std::size_t skin);

 private:
  /// Returns the transform of a node into the scene.
  Eigen::Matrix4d placeInScene(std::size_t node);

  const GlbDocument& document_;
  std::vector<std::uint32_t> parents_{};  // By node; empty until they are needed.
  std::map<std::size_t, std::vector<Eigen::Matrix4d>> joints_{};
  std::size_t count_ = 0;  // Of all joints.
};

/// Moves a primitive's points, bound to a skin's joints, to where these are: by the mean of the
/// transforms of up to 16 joints each, with its weights. Returns whether that mirrors them.
bool poseBySkin(const GlbDocument& document, const GlbDocument::Json& attributes,
                const std::vector<Eigen::Matrix4d>& joints, std::vector<Eigen::Vector3d>& points);

}  // namespace rotatebook::meshes
