#include <gtest/gtest.h>

#include "base/elementary.h"
#include "base/error.h"
#include "meshes/mesh_texts.h"
#include "scene/solid_numbers.h"

namespace rotatebook::scene {
namespace {

BodyPart box(const Eigen::Vector3d& size, double density, const Eigen::Vector3d& place) {
  return {"box", {size.x(), size.y(), size.z()}, density, place, {}};
}

Solid solidOf(std::vector<BodyPart> parts) {
  Solid solid;
  solid.parts = std::move(parts);
  return solid;
}

TEST(Solid, TwoHalvesAreTheWhole) {
  const auto whole = numbersOf(solidOf({box({0.2, 0.3, 0.1}, 500, {0, 0, 0})})).properties;
  const auto halves = numbersOf(solidOf({box({0.1, 0.3, 0.1}, 500, {-0.05, 0, 0}),
                                         box({0.1, 0.3, 0.1}, 500, {0.05, 0, 0})}))
                          .properties;
  EXPECT_NEAR(halves.mass / whole.mass, 1, 1e-15);  // measured 0
  // Measured 2e-16.
  EXPECT_LT((halves.inertia - whole.inertia).norm() / whole.inertia.norm(), 1e-15);
}

TEST(Solid, TakesAwayWhatHasANegativeDensity) {
  const auto hollow = numbersOf(
      solidOf({box({0.2, 0.2, 0.2}, 1000, {0, 0, 0}), box({0.1, 0.1, 0.1}, -1000, {0, 0, 0})}));
  EXPECT_NEAR(hollow.properties.mass, 7, 7e-15);
  EXPECT_NEAR(hollow.properties.volume, 0.007, 7e-18);
  // m a^2 / 6 of both cubes.
  EXPECT_NEAR(hollow.properties.inertia(0, 0), (8 * 0.04 - 1 * 0.01) / 6, 1e-15);
  EXPECT_NEAR(hollow.size.x(), 0.2, 1e-16);
}

TEST(Solid, RefusesWhatTakesAwayTooMuch) {
  EXPECT_THROW(numbersOf(solidOf({box({0.1, 0.1, 0.1}, 1000, {0, 0, 0}),
                                  box({0.2, 0.2, 0.2}, -1000, {0, 0, 0})})),
               InputError);
  // There is mass left, but none at the place of what is taken away.
  EXPECT_THROW(numbersOf(solidOf({box({0.1, 0.1, 0.1}, 1000, {0, 0, 0}),
                                  box({0.05, 0.05, 0.05}, -1000, {5, 0, 0})})),
               InputError);
}

TEST(Solid, TurnsBeforeItMoves) {
  BodyPart part = box({0.2, 0.3, 0.1}, 500, {1, 2, 3});
  part.turn = physics::Tilt{kPi.high / 2, 2};
  const auto turned = numbersOf(solidOf({part}));
  const auto straight = numbersOf(solidOf({box({0.2, 0.3, 0.1}, 500, {0, 0, 0})}));
  EXPECT_NEAR(turned.size.x(), 0.3, 1e-15);  // measured 4e-16
  // Measured 3e-16 and 5e-16.
  EXPECT_LT((turned.properties.centre - Eigen::Vector3d(1, 2, 3)).norm(), 1e-14);
  EXPECT_NEAR(turned.properties.inertia(0, 0) / straight.properties.inertia(1, 1), 1, 1e-14);
}

TEST(Solid, TheMassReplacesTheDensity) {
  Solid solid = solidOf({box({0.2, 0.3, 0.1}, 500, {0, 0, 0})});
  const auto before = numbersOf(solid).properties;
  solid.mass = 6;
  const auto after = numbersOf(solid).properties;
  EXPECT_NEAR(after.mass, 6, 1e-14);
  EXPECT_NEAR(after.inertia(2, 2) / before.inertia(2, 2), 2, 1e-14);
}

TEST(Solid, AMeshHasItsNumbersInItsUnit) {
  const body::TriangleMesh mesh = placed(box({200, 300, 100}, 1, {7, 8, 9})).surface;
  Solid solid;
  solid.mesh = readMeshFile("box.obj", meshes::testing::objOf(mesh));
  solid.mesh.unit = 1e-3;
  solid.density = 500;
  const auto of = numbersOf(solid);
  const auto expected = numbersOf(solidOf({box({0.2, 0.3, 0.1}, 500, {0, 0, 0})}));
  EXPECT_NEAR(of.properties.mass, expected.properties.mass, 1e-14);  // measured 1e-15
  EXPECT_LT((of.properties.inertia - expected.properties.inertia).norm(), 1e-15);
  EXPECT_LT((of.size - expected.size).norm(), 1e-15);
}

}  // namespace
}  // namespace rotatebook::scene
