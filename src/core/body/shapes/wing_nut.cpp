// A wing nut: a hub with a bore along z, and two wings along x that rise with z.
#include <algorithm>
#include <vector>

#include "base/error.h"
#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece wingNutSolid(std::span<const double> lengths) {
  const double hub = lengths[0], bore = lengths[1], height = lengths[2];
  const Eigen::Vector3d wing(lengths[3], lengths[4], lengths[3]);
  if (!(bore < hub)) throw InputError("a wing nut's bore must be smaller than its hub");
  SolidPiece solid = tubeOf(hub, bore, height);
  for (const double side : {-1.0, 1.0}) {
    addMoved(cuboidOf(wing), {side * (hub + wing.x() / 2), 0, wing.z() / 2}, solid);
  }
  return solid;
}

Surface wingNutLook(std::span<const double> lengths) {
  const double hub = lengths[0], bore = lengths[1], height = lengths[2], wing = lengths[3];
  const double edge = 0.2 * (hub - bore), thick = lengths[4];
  const double corner = 0.35 * wing, rounding = std::min(0.3 * thick, corner);
  std::vector<Eigen::Vector2d> outline{{bore, height / 2}, {bore, -height / 2}};
  for (const auto& [z, inset] : roundedLayers(height, std::min(edge, height / 4)))
    outline.emplace_back(hub - inset, z);
  Surface look = surfaceOf(turnedRound(outline), brass(2));
  // A wing begins within the hub's wall
  const double inside = (hub - bore) / 2, length = wing + inside;
  const TriangleMesh flat =
      plateOf({length, wing}, corner, roundedLayers(thick, rounding), true, true);
  for (const double side : {-1.0, 1.0}) {
    TriangleMesh upright = flat;
    for (Eigen::Vector3d& point : upright.points) point = {point.x(), -point.z(), point.y()};
    const double middle = side * (hub - inside + length / 2);
    addSurface(surfaceOf(movedBy(upright, {middle, 0, wing / 2}), brass(0)), look);
  }
  return look;
}

}  // namespace

Shape wingNut() {
  return {
      "wing-nut",
      7850,
      {{"hub", 0.006}, {"bore", 0.003}, {"height", 0.008}, {"wing", 0.012}, {"thickness", 0.003}},
      wingNutSolid,
      wingNutLook};
}

}  // namespace rotatebook::body::shapes
