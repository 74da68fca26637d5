// A telephone: a plate with round corners in the plane x y; 168 g.
#include <algorithm>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece phoneSolid(std::span<const double> lengths) {
  const double corner = lengths[3];
  const Eigen::Vector2d inner(lengths[0] / 2 - corner, lengths[1] / 2 - corner);
  if (!(inner.minCoeff() > 0)) {
    throw InputError("a phone's corner must be less than half of x and of y");
  }
  std::vector<Eigen::Vector2d> outline;
  constexpr int kSteps = 16;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Eigen::Vector2d signs(quarter == 0 || quarter == 3 ? 1 : -1, quarter < 2 ? 1 : -1);
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = kPi.high / 2 * i / kSteps;
      const double c = cosine(angle) * corner, s = sine(angle) * corner;
      const Eigen::Vector2d arc = quarter % 2 == 0 ? Eigen::Vector2d(c, s) : Eigen::Vector2d(s, c);
      outline.push_back((inner + arc).cwiseProduct(signs));
    }
  }
  return prismOf(outline, lengths[2]);
}

/// Returns a camera's lens, a disc around a point of the back. [m]
TriangleMesh lensAt(const Eigen::Vector2d& place, double radius, double thickness, double z) {
  TriangleMesh lens = roundedCylinder(radius, thickness, thickness / 4);
  return movedBy(std::move(lens), {place.x(), place.y(), z});
}

Surface phoneLook(std::span<const double> lengths) {
  const Eigen::Vector2d size(lengths[0], lengths[1]);
  const double corner = lengths[3], half = lengths[2] / 2,
               edge = std::min(0.45 * half, 0.3 * corner);
  const double raised = std::min(0.0004, 0.1 * half), back = half - raised;
  // The band, and glass on both sides
  std::vector<Layer> band = roundedLayers(lengths[2], edge);
  band.front().z = -back;
  Surface look = surfaceOf(plateOf(size, corner, band, false, false), aluminium(1));
  const Layer front{half, edge}, behind{-back, edge};
  addSurface(surfaceOf(plateOf(size, corner, {&front, 1}, false, true),
                       materialOfColour(0x0b0c0f, 0, 0.07F)),
             look);
  addSurface(surfaceOf(plateOf(size, corner, {&behind, 1}, true, false),
                       materialOfColour(0x1f3a52, 0, 0.14F)),
             look);
  const double lens = std::min(0.095 * size.x(), 0.09 * size.y());
  for (const double y : {0.40, 0.29}) {
    const Eigen::Vector2d place(-0.27 * size.x(), y * size.y());
    addSurface(surfaceOf(lensAt(place, lens, raised, -back), aluminium(1)), look);
    addSurface(surfaceOf(lensAt(place, 0.72 * lens, raised, -back - raised / 4),
                         materialOfColour(0x050608, 0, 0.06F)),
               look);
  }
  return look;
}

}  // namespace

Shape phone() {
  return {"phone",
          2080,
          {{"x", 0.0715}, {"y", 0.1467}, {"z", 0.0078}, {"corner", 0.011}},
          phoneSolid,
          phoneLook};
}

}  // namespace rotatebook::body::shapes
