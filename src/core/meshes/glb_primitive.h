// The points, triangles and texture coordinates of a .glb file's primitives. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "meshes/glb_document.h"

namespace rotatebook::meshes {

/// The mode of a primitive whose corners make triangles by threes; below are points and lines.
inline constexpr std::size_t kTriangleList = 4;

/// Returns the weights of a mesh's morph targets, as its node shows it. Empty for none.
std::vector<double> morphWeightsOf(const GlbDocument::Json& node, const GlbDocument::Json& mesh);

/// The positions of a document's primitives.
class GlbPositions {
 public:
  explicit GlbPositions(const GlbDocument& document) : document_(document) {}

  /// Returns a primitive's positions, moved by its morph targets. Throws InputError for what isn't
  /// there or isn't positions, and for morph targets that move more than 10^8 points in all.
  std::vector<Eigen::Vector3d> of(const GlbDocument::Json& primitive,
                                  const std::vector<double>& weights);

 private:
  const GlbDocument& document_;
  std::size_t moved_ = 0;
};

/// Returns the corners of a primitive of so many points as triangles, three each, counter-clockwise
/// from outside. Throws InputError for points and modes that aren't there.
std::vector<std::uint32_t> cornersOf(const GlbDocument& document,
                                     const GlbDocument::Json& primitive, std::size_t mode,
                                     std::size_t points, bool isMirrored);

/// Returns the texture coordinates of a primitive's triangles, as its material's pictures have
/// them; 0 if it has none.
std::vector<std::array<Eigen::Vector2f, 3>> texCoordsOf(const GlbDocument& document,
                                                        const GlbDocument::Json& primitive,
                                                        const std::vector<std::uint32_t>& corners,
                                                        std::size_t points);

}  // namespace rotatebook::meshes
