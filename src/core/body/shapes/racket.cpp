// A tennis racket in the plane x y: a ring as its head, a rod along x as its handle.
#include <array>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece racketSolid(std::span<const double> lengths) {
  const double head = lengths[0], frame = lengths[1], handle = lengths[2], length = lengths[3];
  if (!(frame < head)) throw InputError("a racket's frame must be smaller than its head");
  SolidPiece solid;
  addMoved(ringOf(head, frame), {length + head, 0, 0}, solid);
  addMoved(alongAxis(cylinderOf(handle, length), 1), {length / 2, 0, 0}, solid);
  return solid;
}

constexpr double kGrip = 0.55;  // Of the handle's length.

/// Returns the strings along x or y (0, 1) in a head around the origin. [m]
TriangleMesh stringsAlong(int axis, double head) {
  constexpr int kStrings = 17;
  const double radius = 0.006 * head;
  TriangleMesh strings;
  for (int i = 0; i < kStrings; ++i) {
    const double off = head * (2.0 * (i + 1) / (kStrings + 1) - 1);
    const double half = std::sqrt(head * head - off * off);
    TriangleMesh string = plateOf({2 * radius, 2 * radius}, radius,
                                  std::array{Layer{-half, 0}, Layer{half, 0}}, false, false);
    string = alongAxis(std::move(string), axis + 1);
    const double height = (i % 2 == 0 ? 1 : -1) * (axis == 0 ? 0.5 : -0.5) * radius;
    for (Eigen::Vector3d& point : string.points) {
      point[1 - axis] += off;
      point.z() += height;
    }
    append(string, strings);
  }
  return strings;
}

Surface racketLook(std::span<const double> lengths) {
  const double head = lengths[0], frame = lengths[1], handle = lengths[2], length = lengths[3];
  const Eigen::Vector3d middle(length + head, 0, 0);
  Surface look = surfaceOf(movedBy(ringOf(head, frame).surface, middle), wood(0xc98f4e, 0));
  for (const int axis : {0, 1}) {
    addSurface(
        surfaceOf(movedBy(stringsAlong(axis, head), middle), materialOfColour(0xefe9d6, 0, 0.35F)),
        look);
  }
  const double grip = kGrip * length, shaft = length - grip;
  const TriangleMesh rod = alongAxis(roundedCylinder(0.72 * handle, shaft, 0.1 * handle), 1);
  addSurface(surfaceOf(movedBy(rod, {grip + shaft / 2, 0, 0}), wood(0xb87a3d, 0)), look);
  const TriangleMesh leather = alongAxis(roundedCylinder(handle, grip, 0.2 * handle), 1);
  addSurface(surfaceOf(movedBy(leather, {grip / 2, 0, 0}),
                       materialOfColour(0x2a2522, 0, 0.7F, {{0.006, 0.02, 0.02}, 0.5F, 1e-4F})),
             look);
  return look;
}

}  // namespace

Shape racket() {
  return {"racket",
          600,
          {{"head", 0.13}, {"frame", 0.008}, {"handle", 0.014}, {"length", 0.34}},
          racketSolid,
          racketLook};
}

}  // namespace rotatebook::body::shapes
