// A telephone: a plate with round corners in the plane x y; 168 g.
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
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

}  // namespace

Shape phone() {
  return {
      "phone", 2080, {{"x", 0.0715}, {"y", 0.1467}, {"z", 0.0078}, {"corner", 0.011}}, phoneSolid};
}

}  // namespace rotatebook::body::shapes
