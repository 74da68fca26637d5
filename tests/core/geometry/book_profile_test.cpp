#include "geometry/book_profile.h"

#include <cstddef>

#include <gtest/gtest.h>

namespace rotatebook::geometry {
namespace {

constexpr BookDimensions kBook;

TEST(BookProfile, RunsFromForeEdgeOverTheSpineToForeEdgeWithoutGaps) {
  const auto front = frontProfile(kBook), spine = spineProfile(kBook), back = backProfile(kBook);
  constexpr float kBound = 1e-4F;  // mm; measured 8e-6
  EXPECT_EQ(front.front().outside.x(), kBook.width);
  EXPECT_LT((front.back().outside - spine.front().outside).norm(), kBound);
  EXPECT_LT((spine.back().outside - back.front().outside).norm(), kBound);
  EXPECT_EQ(back.back().outside.x(), kBook.width);
}

TEST(BookProfile, PassesFromBoardToSpineWithoutACrease) {
  constexpr float kBound = 1e-5F;  // measured 6e-8
  const auto front = frontProfile(kBook), spine = spineProfile(kBook);
  EXPECT_LT((front.back().normal - spine.front().normal).norm(), kBound);
}

// Along each profile the normals are square to the curve.
TEST(BookProfile, HasNormalsSquareToItsCurve) {
  constexpr float kBound = 0.14F;  // Sine, of chords of arcs in 30 degree steps. measured 0.13
  const auto points = frontProfile(kBook);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector2f along = (points[i].outside - points[i - 1].outside).normalized();
    const Eigen::Vector2f normal = (points[i].normal + points[i - 1].normal).normalized();
    EXPECT_LT(std::abs(along.dot(normal)), kBound) << "point " << i;
    // Outward is to the right of the way round.
    EXPECT_GT(along.y() * normal.x() - along.x() * normal.y(), 0) << "point " << i;
  }
}

TEST(BookProfile, HasAHingeThatIsShaded) {
  float lowest = kBook.thickness, darkest = 1;
  for (const ProfilePoint& point : frontProfile(kBook)) {
    if (point.outside.x() > 12) continue;
    lowest = std::min(lowest, point.outside.y());
    darkest = std::min(darkest, point.skyVisibility);
  }
  EXPECT_LT(lowest, kBook.thickness - 1.3F);
  EXPECT_LT(darkest, 0.9F);  // measured 0.88
}

TEST(BookProfile, IsTheSameOnBothSides) {
  const auto front = frontProfile(kBook), back = backProfile(kBook);
  ASSERT_EQ(front.size(), back.size());
  for (std::size_t i = 0; i < front.size(); ++i) {
    const ProfilePoint& mirrored = back[front.size() - 1 - i];
    EXPECT_EQ(mirrored.outside.x(), front[i].outside.x());
    EXPECT_EQ(mirrored.outside.y(), kBook.thickness - front[i].outside.y());
    EXPECT_EQ(mirrored.normal.y(), -front[i].normal.y());
  }
}

}  // namespace
}  // namespace rotatebook::geometry
