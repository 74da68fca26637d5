#include "body/closed_mesh.h"

#include <numeric>

#include "base/error.h"
#include "base/number_text.h"
#include "body/closed_surface.h"
#include "body/near_points.h"
#include "body/voids.h"

namespace rotatebook::body {
namespace {

/// Leaves out the triangles with a corner twice, with their materials and texture coordinates, the
/// points that no triangle uses then, and `numbers` of the triangles.
void leaveOutEmpty(Surface& surface, std::vector<std::uint32_t>& numbers) {
  auto& triangles = surface.mesh.triangles;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto [a, b, c] = triangles[i];
    if (a == b || b == c || c == a) continue;
    triangles[kept] = triangles[i];
    numbers[kept] = numbers[i];
    if (!surface.materialOf.empty()) surface.materialOf[kept] = surface.materialOf[i];
    if (!surface.texCoords.empty()) surface.texCoords[kept] = surface.texCoords[i];
    ++kept;
  }
  if (kept == triangles.size()) return;
  triangles.resize(kept);
  numbers.resize(kept);
  if (!surface.materialOf.empty()) surface.materialOf.resize(kept);
  if (!surface.texCoords.empty()) surface.texCoords.resize(kept);
  surface.mesh = welded(surface.mesh);
}

std::string sizeTextOf(const TriangleMesh& mesh) {
  const auto [low, high] = boxAround(mesh.points);
  return roundedText((high - low).maxCoeff(), 3);
}

std::string noteOn(const JoinedPoints& joined, const std::string& size) {
  const std::string far = roundedText(joined.distance, 2), end = "; the mesh is " + size + " long";
  if (joined.count == 1) return "one point is taken as another that lies " + far + " from it" + end;
  return std::to_string(joined.count) + " points are taken as others that lie " + far +
         " or less from them" + end;
}

std::string noteOnEmpty(std::size_t count) {
  if (count == 1) return "one triangle has a corner twice, and is left out";
  return std::to_string(count) + " triangles have a corner twice, and are left out";
}

/// Joins points that are near each other, and notes it.
void joinNear(Surface& surface, Closing& closing) {
  if (surface.mesh.points.empty()) return;
  const std::string size = sizeTextOf(surface.mesh);
  const JoinedPoints joined = joinNearPoints(surface.mesh);
  if (joined.count == 0) return;
  closing.notes.push_back(noteOn(joined, size));
  surface.mesh = welded(surface.mesh);
  leaveOutEmpty(surface, closing.numbers);
}

}  // namespace

Closing closeSurface(Surface& surface) {
  surface.mesh = welded(surface.mesh);
  const std::size_t all = surface.mesh.triangles.size();
  Closing closing{std::vector<std::uint32_t>(all), {}};
  std::iota(closing.numbers.begin(), closing.numbers.end(), 0U);
  leaveOutEmpty(surface, closing.numbers);
  if (!isClosed(surface.mesh)) {
    joinNear(surface, closing);
    if (all > 0 && closing.numbers.empty()) {
      throw InputError(
          (all == 1 ? "its one triangle" : "each of its " + std::to_string(all) + " triangles") +
          std::string(" has a corner twice, and no area; export it again"));
    }
    requireClosed(surface.mesh, closing.numbers);
  }
  requireVoidsInside(surface.mesh, closing.numbers);
  const std::size_t left = all - closing.numbers.size();
  if (left > 0) closing.notes.push_back(noteOnEmpty(left));
  if (left == 0) closing.numbers.clear();
  return closing;
}

}  // namespace rotatebook::body
