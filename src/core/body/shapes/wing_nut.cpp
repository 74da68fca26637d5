// A wing nut: a hub with a bore along z, and two wings along x that rise with z.
#include "base/error.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece wingNutSolid(std::span<const double> lengths) {
  const double hub = lengths[0], bore = lengths[1], height = lengths[2];
  const Eigen::Vector3d wing(lengths[3], lengths[4], lengths[3]);
  if (!(bore < hub)) throw InputError("a wing nut's bore must be smaller than its hub");
  SolidPiece solid = tubeOf(hub, bore, height);
  for (const double side : {-1.0, 1.0}) {
    addMoved(cuboidOf(wing), {side * (hub + wing.x() / 2), 0, wing.z() / 2}, solid);
  }
  return solid;
}

}  // namespace

Shape wingNut() {
  return {
      "wing-nut",
      7850,
      {{"hub", 0.006}, {"bore", 0.003}, {"height", 0.008}, {"wing", 0.012}, {"thickness", 0.003}},
      wingNutSolid};
}

}  // namespace rotatebook::body::shapes
