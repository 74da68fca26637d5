// A disc across the axis z.
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece discSolid(std::span<const double> lengths) {
  return cylinderOf(lengths[0], lengths[1]);
}

}  // namespace

Shape disc() {
  return {"disc", 1200, {{"radius", 0.135}, {"thickness", 0.01}}, discSolid};
}

}  // namespace rotatebook::body::shapes
