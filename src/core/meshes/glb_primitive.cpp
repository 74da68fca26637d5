#include "meshes/glb_primitive.h"

#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "meshes/glb_materials.h"
#include "meshes/glb_numbers.h"

namespace rotatebook::meshes {
namespace {

using Json = GlbDocument::Json;

constexpr std::size_t kStrip = 5, kFan = 6;     // modes
constexpr std::size_t kMaxMoved = 100'000'000;  // points that morph targets move

void requirePositions(const GlbNumbers& numbers) {
  if (!numbers.areUnsigned32()) return;
  throw InputError("positions must be floats or short numbers; export the file again");
}

/// Returns the index of the point of a primitive's corner.
std::uint32_t indexOf(const GlbNumbers& numbers, std::size_t i, std::size_t points) {
  const std::uint32_t index = numbers.indexAt(i);
  if (index < points) return index;
  throw InputError("triangle " + std::to_string(i / 3 + 1) + " of a mesh names point " +
                   std::to_string(index) + ", counted from 0, but there are " +
                   std::to_string(points) + "; export the file again");
}

/// Returns the corners of a strip or fan as triangles.
std::vector<std::uint32_t> unrolled(const std::vector<std::uint32_t>& corners, bool isFan) {
  std::vector<std::uint32_t> all;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const bool isBack = !isFan && i % 2 == 1;  // every second one of a strip
    const std::uint32_t one = isFan ? corners[0] : corners[i - 2], other = corners[i - 1];
    all.insert(all.end(), {isBack ? other : one, isBack ? one : other, corners[i]});
  }
  return all;
}

}  // namespace

std::vector<double> morphWeightsOf(const Json& node, const Json& mesh) {
  const Json& own = GlbDocument::member(node, "weights");
  std::vector<double> weights;
  for (const Json& weight : own.is_null() ? GlbDocument::member(mesh, "weights") : own) {
    if (!weight.is_number())
      throw InputError("a weight of a morph target isn't a number; export the file again");
    weights.push_back(weight.get<double>());
  }
  return weights;
}

std::vector<Eigen::Vector3d> GlbPositions::of(const Json& primitive,
                                              const std::vector<double>& weights) {
  const Json& attributes = GlbDocument::member(primitive, "attributes");
  const GlbNumbers base(document_, GlbDocument::count(attributes, "POSITION").value_or(0),
                        {"VEC3", 3});
  requirePositions(base);
  std::vector<Eigen::Vector3d> points(base.count());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = base.vectorAt(i);
  const Json& targets = GlbDocument::member(primitive, "targets");
  for (std::size_t target = 0; target < std::min(weights.size(), targets.size()); ++target) {
    const auto accessor = GlbDocument::count(targets[target], "POSITION");
    if (weights[target] == 0 || !accessor) continue;
    moved_ += points.size();
    if (moved_ > kMaxMoved)
      throw InputError("its morph targets move more than 10^8 points; apply them, and export");
    const GlbNumbers shift(document_, *accessor, {"VEC3", 3, points.size()});
    requirePositions(shift);
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] += weights[target] * shift.vectorAt(i);
  }
  return points;
}

std::vector<std::uint32_t> cornersOf(const GlbDocument& document, const Json& primitive,
                                     std::size_t mode, std::size_t points, bool isMirrored) {
  std::vector<std::uint32_t> corners;
  if (const auto accessor = GlbDocument::count(primitive, "indices")) {
    const GlbNumbers numbers(document, *accessor, {"SCALAR", 1});
    for (std::size_t i = 0; i < numbers.count(); ++i)
      corners.push_back(indexOf(numbers, i, points));
  } else {
    for (std::size_t i = 0; i < points; ++i) corners.push_back(static_cast<std::uint32_t>(i));
  }
  if (mode > kFan)
    throw InputError("a mesh is of the mode " + std::to_string(mode) + "; export triangles (4)");
  if (mode != kTriangleList) corners = unrolled(corners, mode == kFan);
  if (corners.size() % 3 != 0)
    throw InputError("a list of triangles has " + std::to_string(corners.size()) +
                     " corners, no multiple of 3; export the file again");
  for (std::size_t i = 0; isMirrored && i < corners.size(); i += 3)
    std::swap(corners[i + 1], corners[i + 2]);
  return corners;
}

std::vector<std::array<Eigen::Vector2f, 3>> texCoordsOf(const GlbDocument& document,
                                                        const Json& primitive,
                                                        const std::vector<std::uint32_t>& corners,
                                                        std::size_t points) {
  std::vector<Eigen::Vector2f> all(points, Eigen::Vector2f::Zero());
  const PictureUse use = pictureUseOf(document, primitive);
  const Json& attributes = GlbDocument::member(primitive, "attributes");
  if (const auto accessor = GlbDocument::count(attributes, texCoordName(use).c_str())) {
    const GlbNumbers numbers(document, *accessor, {"VEC2", 2, points});
    for (std::size_t i = 0; i < points; ++i)
      all[i] = use.applied({numbers.at(i, 0), numbers.at(i, 1)}).cast<float>();
  }
  std::vector<std::array<Eigen::Vector2f, 3>> coordinates;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    coordinates.push_back({all[corners[i]], all[corners[i + 1]], all[corners[i + 2]]});
  return coordinates;
}

}  // namespace rotatebook::meshes
