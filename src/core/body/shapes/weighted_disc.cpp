// Tao's disc across the axis z: two heavy weights on its rim on x, two light ones on y. It weighs
// nothing itself, and the weights count as points.
// Source: Terence Tao, mathoverflow.net/questions/82020.
#include <array>
#include <numbers>

#include "base/error.h"
#include "body/look_pieces.h"
#include "body/shapes/shapes.h"
#include "body/solid_pieces.h"

namespace rotatebook::body::shapes {
namespace {

constexpr double kThickness = 0.03;  // Of the disc, per its radius.

/// The numbers of `lengths`. [m]
struct WeightedDisc {
  explicit WeightedDisc(std::span<const double> lengths)
      : radius(lengths[0]), heavy(lengths[1]), light(lengths[2]) {}

  double radius, heavy, light;
};

/// Returns a ball, as smooth at its size as the disc is at its own.
SolidPiece ballOf(double radius) {
  constexpr int kBallSides = 48;
  return ellipsoidOf(Eigen::Vector3d::Constant(2 * radius), kBallSides);
}

std::vector<PointMass> discWeights(std::span<const double> lengths) {
  const WeightedDisc disc(lengths);
  const auto volume = [](double radius) {
    return 4 * std::numbers::pi / 3 * radius * radius * radius;
  };
  const double r = disc.radius, heavy = volume(disc.heavy), light = volume(disc.light);
  return {{heavy, {r, 0, 0}}, {heavy, {-r, 0, 0}}, {light, {0, r, 0}}, {light, {0, -r, 0}}};
}

/// Returns a surface at each of the weights.
template <typename Place>
void placeWeights(const WeightedDisc& disc, const Place& place) {
  for (const double side : {1.0, -1.0}) {
    place(disc.heavy, Eigen::Vector3d(side * disc.radius, 0, 0));
    place(disc.light, Eigen::Vector3d(0, side * disc.radius, 0));
  }
}

SolidPiece weightedDiscSolid(std::span<const double> lengths) {
  const WeightedDisc disc(lengths);
  if (!(disc.heavy < disc.radius && disc.light < disc.radius))
    throw InputError("a weighted disc's weights must be smaller than the disc");
  SolidPiece solid = cylinderOf(disc.radius, kThickness * disc.radius);
  placeWeights(disc, [&](double radius, const Eigen::Vector3d& place) {
    addMoved(ballOf(radius), place, solid);
  });
  solid.properties = {};
  for (const PointMass& weight : discWeights(lengths)) {
    solid.properties.mass += weight.mass;
    solid.properties.inertia +=
        weight.mass * (weight.place.squaredNorm() * Eigen::Matrix3d::Identity() -
                       weight.place * weight.place.transpose());
  }
  solid.properties.volume = solid.properties.mass;
  return solid;
}

Surface weightedDiscLook(std::span<const double> lengths) {
  const WeightedDisc disc(lengths);
  const double thickness = kThickness * disc.radius;
  Surface look = surfaceOf(roundedCylinder(disc.radius, thickness, 0.4 * thickness),
                           materialOfColour(0xd9d3c3, 0, 0.45F));
  placeWeights(disc, [&](double radius, const Eigen::Vector3d& place) {
    const bool isHeavy = place.x() != 0;
    const Material material =
        isHeavy ? materialOfColour(0xb5402c, 0, 0.3F) : materialOfColour(0x2f6fb0, 0, 0.3F);
    addSurface(surfaceOf(movedBy(ballOf(radius).surface, place), material), look);
  });
  return look;
}

}  // namespace

Shape weightedDisc() {
  return {"weighted-disc",
          7850,
          {{"radius", 0.15}, {"heavy", 0.024}, {"light", 0.011}},
          weightedDiscSolid,
          weightedDiscLook,
          discWeights};
}

}  // namespace rotatebook::body::shapes
