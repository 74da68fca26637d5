// A T-handle: a bar along x, and a stem along y on its side.
#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece tHandleSolid(std::span<const double> lengths) {
  const double radius = lengths[0], bar = lengths[1], stem = lengths[2];
  SolidPiece solid;
  addMoved(alongAxis(cylinderOf(radius, bar), 1), {0, 0, 0}, solid);
  addMoved(alongAxis(cylinderOf(radius, stem), 2), {0, radius + stem / 2, 0}, solid);
  return solid;
}

Surface tHandleLook(std::span<const double> lengths) {
  const double radius = lengths[0], bar = lengths[1], stem = lengths[2], edge = 0.2 * radius;
  Surface look = surfaceOf(alongAxis(roundedCylinder(radius, bar, edge), 1), aluminium(0));
  // The stem begins within the bar
  const double length = radius + stem;
  const TriangleMesh along = alongAxis(roundedCylinder(0.98 * radius, length, edge), 2);
  addSurface(surfaceOf(movedBy(along, {0, length / 2, 0}), aluminium(1)), look);
  return look;
}

}  // namespace

Shape tHandle() {
  return {"t-handle",
          2700,
          {{"radius", 0.008}, {"bar", 0.12}, {"stem", 0.06}},
          tHandleSolid,
          tHandleLook};
}

}  // namespace rotatebook::body::shapes
