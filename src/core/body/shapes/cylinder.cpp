// A cylinder along the axis z.
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece cylinderSolid(std::span<const double> lengths) {
  return cylinderOf(lengths[0], lengths[1]);
}

}  // namespace

Shape cylinder() {
  return {"cylinder", 2700, {{"radius", 0.05}, {"height", 0.2}}, cylinderSolid};
}

}  // namespace rotatebook::body::shapes
