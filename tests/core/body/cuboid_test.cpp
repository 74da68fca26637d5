#include "body/cuboid.h"

#include <gtest/gtest.h>

namespace rotatebook::body {
namespace {

constexpr double kCuboidBound = 1e-16;  // [kg m^2]; measured 8e-18

TEST(Cuboid, HasCornersSignedByTheBitsOfTheirIndex) {
  Cage expected;
  expected << -1, 1, -1, 1, -1, 1, -1, 1,  //
      -2, -2, 2, 2, -2, -2, 2, 2,          //
      -3, -3, -3, -3, 3, 3, 3, 3;
  EXPECT_EQ((Cuboid{{2, 4, 6}, 1}.corners()), expected);
}

TEST(Cuboid, HasTheSolidInertiaOfATextbook) {
  EXPECT_EQ((Cuboid{{1, 2, 3}, 12}.solidInertia()), Eigen::Vector3d(13, 10, 5));
}

TEST(Cuboid, HasTheInertiaOfEightParticles) {
  const Cuboid book;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Cage corners = book.corners();
  for (const auto& c : corners.colwise()) {
    sum.x() += book.mass / 8 * (c.y() * c.y() + c.z() * c.z());
    sum.y() += book.mass / 8 * (c.z() * c.z() + c.x() * c.x());
    sum.z() += book.mass / 8 * (c.x() * c.x() + c.y() * c.y());
  }
  EXPECT_LT((book.particleInertia() - sum).norm(), kCuboidBound);
  EXPECT_LT((book.particleInertia() - 3 * book.solidInertia()).norm(), kCuboidBound);
}

TEST(Cuboid, IsABookWithItsMiddleMomentAboutX) {
  const Eigen::Vector3d inertia = Cuboid().solidInertia();
  EXPECT_LT(inertia.y(), inertia.x());
  EXPECT_LT(inertia.x(), inertia.z());
}

TEST(Cuboid, KnowsItsLongestEdge) {
  EXPECT_EQ((Cuboid{{1, 3, 2}, 1}.largestDimension()), 3);
}

}  // namespace
}  // namespace rotatebook::body
