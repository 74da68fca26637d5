// A cylinder along the axis z.
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

TriangleMesh cylinderMesh(std::span<const double> lengths) {
  return cylinderOf(lengths[0], lengths[1]);
}

}  // namespace

Shape cylinder() {
  return {"cylinder", 2700, {{"radius", 0.05}, {"height", 0.2}}, cylinderMesh};
}

}  // namespace rotatebook::body::shapes
