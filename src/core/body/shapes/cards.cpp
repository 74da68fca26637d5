// A deck of cards: 52 and two jokers, of the size for poker, weigh 94 g.
#include <algorithm>
#include <array>

#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

SolidPiece cardsSolid(std::span<const double> lengths) {
  return cuboidOf({lengths[0], lengths[1], lengths[2]});
}

Surface cardsLook(std::span<const double> lengths) {
  const Eigen::Vector2d size(lengths[0], lengths[1]);
  const double least = size.minCoeff(), corner = 0.055 * least, border = 0.05 * least;
  const double half = lengths[2] / 2, edge = std::min(0.002 * least, 0.2 * half);
  const Material paper = materialOfColour(0xf3efe6, 0, 0.6F),
                 back = materialOfColour(0xa3202c, 0, 0.5F);
  const Material sheets = materialOfColour(0xe9e4d8, 0, 0.8F, {{0.02, 0.02, 0.0003}, 0.22F, 1e-5F});
  Surface look =
      surfaceOf(plateOf(size, corner, roundedLayers(lengths[2], edge), false, false), sheets);
  for (const double side : {-1.0, 1.0}) {
    const Layer rim{side * half, edge}, inner{side * half, border};
    const auto frame = side > 0 ? std::array{rim, inner} : std::array{inner, rim};
    addSurface(surfaceOf(plateOf(size, corner, frame, false, false), paper), look);
    const bool isTop = side > 0;
    addSurface(surfaceOf(plateOf(size, corner, {&inner, 1}, !isTop, isTop), back), look);
  }
  return look;
}

}  // namespace

Shape cards() {
  return {"cards", 950, {{"x", 0.0635}, {"y", 0.0889}, {"z", 0.0175}}, cardsSolid, cardsLook};
}

}  // namespace rotatebook::body::shapes
