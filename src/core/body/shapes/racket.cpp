// A tennis racket in the plane x y: a ring as its head, a rod along x as its handle.
#include "base/error.h"
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

}  // namespace

Shape racket() {
  return {"racket",
          600,
          {{"head", 0.13}, {"frame", 0.008}, {"handle", 0.014}, {"length", 0.34}},
          racketSolid};
}

}  // namespace rotatebook::body::shapes
