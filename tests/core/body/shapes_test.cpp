#include <algorithm>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "body/closed_surface.h"
#include "body/mass_properties.h"
#include "body/message_of.h"
#include "body/shape.h"

namespace rotatebook::body {
namespace {

using Eigen::Vector3d;
using testing::messageOf;

std::vector<double> defaultsOf(const Shape& shape) {
  std::vector<double> lengths;
  for (const ShapeLength& length : shape.lengths) lengths.push_back(length.byDefault);
  return lengths;
}

MassProperties propertiesOf(const char* name, const std::vector<double>& lengths, double density) {
  MassProperties found = findShape(name)->solid(lengths).properties;
  found.mass *= density;
  found.inertia *= density;
  return found;
}

void expectMoments(const MassProperties& of, const Vector3d& expected, double within) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(of.inertia(i, i) / expected[i], 1, within) << i;
  const double largest = of.inertia.diagonal().maxCoeff();
  for (const auto& [i, j] : {std::pair(0, 1), {1, 2}, {2, 0}})
    EXPECT_LT(std::abs(of.inertia(i, j)) / largest, 1e-14) << i << j;  // measured 2e-16
}

double extentOf(const TriangleMesh& mesh) {
  double extent = 0;
  for (const Vector3d& point : mesh.points) extent = std::max(extent, point.norm());
  return extent;
}

/// Returns whether all points are in the box around others, but for rounding.
bool areWithin(const TriangleMesh& mesh, const TriangleMesh& others) {
  const Vector3d room = Vector3d::Constant(1e-12 * extentOf(others));  // measured 3e-16
  Vector3d low = others.points.front(), high = low;
  for (const Vector3d& point : others.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return std::ranges::all_of(mesh.points, [&](const Vector3d& point) {
    return (point - low + room).minCoeff() >= 0 && (high - point + room).minCoeff() >= 0;
  });
}

TEST(Shapes, LookLikeWhatIsWithinTheirBox) {
  for (const Shape& shape : allShapes()) {
    for (std::size_t i = 0; i < shape.lengths.size(); ++i) {
      for (const double factor : {0.1, 0.4, 1.0, 1.6, 10.0}) {
        std::vector<double> lengths = defaultsOf(shape);
        lengths[i] *= factor;
        TriangleMesh solid;
        if (messageOf([&] { solid = shape.solid(lengths).surface; }) != "accepted") continue;
        EXPECT_TRUE(areWithin(shape.look(lengths).mesh, solid))
            << shape.name << ' ' << shape.lengths[i].name << ' ' << lengths[i];
      }
    }
  }
}

TEST(Shapes, AreClosedAndHaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Shape& shape : allShapes()) {
    SCOPED_TRACE(std::string(shape.name));
    const SolidPiece solid = shape.solid(defaultsOf(shape));
    const TriangleMesh& mesh = solid.surface;
    EXPECT_NO_THROW(requireClosed(mesh));
    EXPECT_EQ(welded(mesh).points.size(), mesh.points.size());
    EXPECT_TRUE(names.insert(shape.name).second);
    EXPECT_EQ(findShape(shape.name), &shape);
    if (shape.weights != nullptr) continue;  // not a solid
    // The facets have the round solid's volume, and larger moments: measured by 1.0e-7.
    const MassProperties facetted = massPropertiesOf(mesh, 1);
    EXPECT_NEAR(facetted.volume / solid.properties.volume, 1, 1e-13);  // measured 6e-16
    // measured 8e-17
    EXPECT_LT((facetted.centre - solid.properties.centre).norm(), 1e-14 * extentOf(mesh));
    EXPECT_LT((facetted.inertia - solid.properties.inertia).norm() / facetted.inertia.norm(), 2e-7);
  }
  EXPECT_EQ(names.size(), 11U);
  EXPECT_EQ(findShape("teapot"), nullptr);
}

TEST(Shapes, WeightsHaveTheMassAndTheMomentsOfTheirBody) {
  const Shape& disc = *findShape("weighted-disc");
  const std::vector<double> lengths{0.2, 0.03, 0.01};
  const MassProperties whole = disc.solid(lengths).properties;
  double mass = 0;
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();
  for (const PointMass& weight : disc.weights(lengths)) {
    const Eigen::Vector3d squares = weight.place.cwiseAbs2();
    mass += weight.mass;
    moments += weight.mass * (squares.sum() * Eigen::Vector3d::Ones() - squares);
  }
  EXPECT_NEAR(whole.mass / mass, 1, 1e-15);                              // measured 0
  EXPECT_LT((whole.inertia.diagonal() - moments).norm() / mass, 1e-17);  // measured 0
  EXPECT_NEAR(moments.y() / moments.x(), 27, 1e-12);                     // measured 3.6e-15
  EXPECT_NEAR(whole.inertia(2, 2), moments.x() + moments.y(), 1e-20);    // measured 1.7e-21
}

TEST(Shapes, ABoxIsExact) {
  const auto of = propertiesOf("box", {0.15, 0.22, 0.04}, 1);
  EXPECT_NEAR(of.volume / 0.00132, 1, 1e-15);                 // measured 0
  expectMoments(of, {5.5e-06, 2.651e-06, 7.799e-06}, 1e-14);  // measured 4e-16
}

TEST(Shapes, RoundOnesAreExact) {
  const auto cylinder = propertiesOf("cylinder", {0.5, 2}, 1);
  EXPECT_NEAR(cylinder.volume / 1.5707963267948966, 1, 1e-14);  // measured 0
  expectMoments(cylinder, {0.62177354602298, 0.62177354602298, 0.19634954084936207},
                1e-14);  // measured 2e-16
  const auto ball = propertiesOf("ellipsoid", {2, 2, 2}, 1);
  EXPECT_NEAR(ball.volume / 4.1887902047863905, 1, 1e-14);  // measured 0
  const double moment = 0.4 * 4.1887902047863905;
  expectMoments(ball, {moment, moment, moment}, 1e-14);  // measured 0
}

/// Returns the volume, and the moment about z for a density of 1, of a plate with round corners.
std::pair<double, double> roundedPlate(double x, double y, double z, double corner) {
  using std::numbers::pi;
  const double c = corner;
  // The integral of y^2 over the outline: the rectangle, less what a square has beyond its quarter
  const auto second = [&](double width, double height) {
    const double b = height / 2, inner = b - c;
    const double square = c * (b * b * b - inner * inner * inner) / 3;
    const double quarter =
        inner * inner * pi * c * c / 4 + 2 * inner * c * c * c / 3 + pi * c * c * c * c / 16;
    return width * height * height * height / 12 - 4 * (square - quarter);
  };
  return {z * (x * y - (4 - pi) * c * c), z * (second(x, y) + second(y, x))};
}

// docs/bodies.md states by how much.
TEST(Shapes, ThePhoneLacksALittleOfItsRoundCorners) {
  const auto lacks = [](double x, double y, double z, double corner) {
    const auto [volume, moment] = roundedPlate(x, y, z, corner);
    const auto phone = propertiesOf("phone", {x, y, z, corner}, 1);
    return std::pair(1 - phone.volume / volume, 1 - phone.inertia(2, 2) / moment);
  };
  const auto usual = lacks(0.0715, 0.1467, 0.0078, 0.011);
  EXPECT_NEAR(usual.first, 5.9e-5, 1e-6);
  EXPECT_NEAR(usual.second, 1.6e-4, 1e-5);
  const auto round = lacks(0.1, 0.1, 0.01, 0.0499);
  EXPECT_NEAR(round.first, 0.0016, 1e-4);
  EXPECT_NEAR(round.second, 0.0032, 1e-4);
}

TEST(Shapes, TheTHandleHasTheReferenceMoments) {
  const auto of = propertiesOf("t-handle", {0.008, 0.12, 0.06}, 2700);
  EXPECT_NEAR(of.mass / 0.09771609789725692, 1, 1e-14);     // measured 2e-16
  EXPECT_NEAR(of.centre.y(), 0.012666666666666666, 1e-16);  // measured 4e-18
  expectMoments(of, {4.373338248112788e-05, 8.025748840628036e-05, 0.00012086395575469602},
                1e-14);  // measured 3e-16
}

TEST(Shapes, TheRacketHasTheReferenceMoments) {
  const auto of = propertiesOf("racket", {0.13, 0.008, 0.014, 0.34}, 600);
  EXPECT_NEAR(of.mass / 0.22415157100161046, 1, 1e-14);           // measured 7e-16
  EXPECT_NEAR(of.centre.x(), 0.18188147185428585 + 0.12, 1e-15);  // measured 6e-17
  expectMoments(of, {0.0008488988437754337, 0.007022645561940048, 0.007856081068359796},
                1e-14);  // measured 2e-16
}

TEST(Shapes, ToutatisHasItsRatios) {
  const Vector3d moments = propertiesOf("toutatis", {4600}, 2100).inertia.diagonal();
  EXPECT_NEAR(moments.y() / moments.x(), 3.09, 1e-14);  // measured 4e-16
  EXPECT_NEAR(moments.z() / moments.x(), 3.22, 1e-14);  // measured 0
}

}  // namespace
}  // namespace rotatebook::body
