#include "body/surface.h"

namespace rotatebook::body {

Eigen::Vector3d grainsAcross(const Grain& grain, const Eigen::Vector3d& size) {
  if (grain.contrast > 0 || grain.relief > 0) return size.cwiseQuotient(grain.size);
  return Eigen::Vector3d::Zero();
}

void addSurface(const Surface& added, Surface& into) {
  const auto first = static_cast<std::uint32_t>(into.materials.size());
  into.materialOf.resize(into.mesh.triangles.size(), 0);
  append(added.mesh, into.mesh);
  for (std::size_t i = 0; i < added.mesh.triangles.size(); ++i)
    into.materialOf.push_back(first + (added.materialOf.empty() ? 0 : added.materialOf[i]));
  into.materials.insert(into.materials.end(), added.materials.begin(), added.materials.end());
}

}  // namespace rotatebook::body
