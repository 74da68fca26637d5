// A deck of cards: 52 and two jokers, of the size for poker, weigh 94 g.
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece cardsSolid(std::span<const double> lengths) {
  return cuboidOf({lengths[0], lengths[1], lengths[2]});
}

}  // namespace

Shape cards() {
  return {"cards", 950, {{"x", 0.0635}, {"y", 0.0889}, {"z", 0.0175}}, cardsSolid};
}

}  // namespace rotatebook::body::shapes
