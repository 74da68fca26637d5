// A T-handle: a bar along x, and a stem along y on its side.
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

TriangleMesh tHandleMesh(std::span<const double> lengths) {
  const double radius = lengths[0], bar = lengths[1], stem = lengths[2];
  TriangleMesh mesh;
  addMoved(alongAxis(cylinderOf(radius, bar), 1), {0, 0, 0}, mesh);
  addMoved(alongAxis(cylinderOf(radius, stem), 2), {0, radius + stem / 2, 0}, mesh);
  return mesh;
}

}  // namespace

Shape tHandle() {
  return {"t-handle", 2700, {{"radius", 0.008}, {"bar", 0.12}, {"stem", 0.06}}, tHandleMesh};
}

}  // namespace rotatebook::body::shapes
