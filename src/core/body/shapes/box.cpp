// A cuboid.
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece boxSolid(std::span<const double> lengths) {
  return cuboidOf({lengths[0], lengths[1], lengths[2]});
}

}  // namespace

Shape box() {
  return {"box", 700, {{"x", 0.2}, {"y", 0.3}, {"z", 0.05}}, boxSolid};
}

}  // namespace rotatebook::body::shapes
