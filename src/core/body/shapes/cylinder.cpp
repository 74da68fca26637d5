// A cylinder along the axis z.
#include <algorithm>

#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece cylinderSolid(std::span<const double> lengths) {
  return cylinderOf(lengths[0], lengths[1]);
}

Surface cylinderLook(std::span<const double> lengths) {
  const double edge = 0.05 * std::min(lengths[0], lengths[1]);
  return surfaceOf(roundedCylinder(lengths[0], lengths[1], edge), aluminium(2));
}

}  // namespace

Shape cylinder() {
  return {"cylinder", 2700, {{"radius", 0.05}, {"height", 0.2}}, cylinderSolid, cylinderLook};
}

}  // namespace rotatebook::body::shapes
