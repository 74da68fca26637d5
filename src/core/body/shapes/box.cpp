// A cuboid.
#include <algorithm>

#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece boxSolid(std::span<const double> lengths) {
  return cuboidOf({lengths[0], lengths[1], lengths[2]});
}

Surface boxLook(std::span<const double> lengths) {
  const double least = *std::ranges::min_element(lengths), edge = 0.06 * least;
  return surfaceOf(
      plateOf({lengths[0], lengths[1]}, edge, roundedLayers(lengths[2], edge), true, true),
      wood(0xc08a52, 1));
}

}  // namespace

Shape box() {
  return {"box", 700, {{"x", 0.2}, {"y", 0.3}, {"z", 0.05}}, boxSolid, boxLook};
}

}  // namespace rotatebook::body::shapes
