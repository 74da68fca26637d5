// (4179) Toutatis, 4.6 km long, as the ellipsoid with its moments, 1 : 3.09 : 3.22 (Hudson and
// Ostro 1995): a^2 : b^2 : c^2 = 2.655 : 0.565 : 0.435.
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece toutatisSolid(std::span<const double> lengths) {
  const Eigen::Vector3d squares(2.655, 0.565, 0.435);
  return ellipsoidOf((squares / squares.x()).cwiseSqrt() * lengths[0]);
}

}  // namespace

Shape toutatis() {
  return {"toutatis", 2100, {{"length", 4600}}, toutatisSolid};
}

}  // namespace rotatebook::body::shapes
