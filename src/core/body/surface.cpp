#include "body/surface.h"

namespace rotatebook::body {

void addSurface(const Surface& added, Surface& into) {
  const auto firstPoint = static_cast<std::uint32_t>(into.mesh.points.size());
  const auto firstMaterial = static_cast<std::uint32_t>(into.materials.size());
  into.materialOf.resize(into.mesh.triangles.size(), 0);
  into.mesh.points.insert(into.mesh.points.end(), added.mesh.points.begin(),
                          added.mesh.points.end());
  for (std::size_t i = 0; i < added.mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = added.mesh.triangles[i];
    into.mesh.triangles.push_back({firstPoint + a, firstPoint + b, firstPoint + c});
    into.materialOf.push_back(firstMaterial + (added.materialOf.empty() ? 0 : added.materialOf[i]));
  }
  into.materials.insert(into.materials.end(), added.materials.begin(), added.materials.end());
}

}  // namespace rotatebook::body
