// An ellipsoid with its diameters along the axes.
#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece ellipsoidSolid(std::span<const double> lengths) {
  return ellipsoidOf({lengths[0], lengths[1], lengths[2]});
}

Surface ellipsoidLook(std::span<const double> lengths) {
  return surfaceOf(ellipsoidSolid(lengths).surface, materialOfColour(0x2c8c86, 0, 0.16F));
}

}  // namespace

Shape ellipsoid() {
  return {"ellipsoid", 1000, {{"x", 0.2}, {"y", 0.14}, {"z", 0.1}}, ellipsoidSolid, ellipsoidLook};
}

}  // namespace rotatebook::body::shapes
