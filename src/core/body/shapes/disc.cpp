// A disc across the axis z.
#include <algorithm>

#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece discSolid(std::span<const double> lengths) {
  return cylinderOf(lengths[0], lengths[1]);
}

Surface discLook(std::span<const double> lengths) {
  const double edge = 0.499 * std::min(lengths[0], lengths[1]);
  return surfaceOf(roundedCylinder(lengths[0], lengths[1], edge),
                   materialOfColour(0xe2622b, 0, 0.28F));
}

}  // namespace

Shape disc() {
  return {"disc", 1200, {{"radius", 0.135}, {"thickness", 0.01}}, discSolid, discLook};
}

}  // namespace rotatebook::body::shapes
