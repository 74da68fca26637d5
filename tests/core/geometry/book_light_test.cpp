#include "geometry/book_light.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

namespace rotatebook::geometry {
namespace {

using Eigen::Vector3f;

constexpr BookDimensions kHardback;

/// Returns the share of the surroundings above a side along z and x, upward along y, that isn't
/// hidden, as a matt surface weighs it.
float seenShare(const std::function<bool(const Vector3f&)>& isHidden) {
  constexpr int kHeights = 60, kTurns = 240;
  int seen = 0;
  for (int i = 0; i < kHeights; ++i) {
    const float square = (static_cast<float>(i) + 0.5F) / kHeights, up = std::sqrt(1 - square);
    for (int j = 0; j < kTurns; ++j) {
      const float turn = 2 * std::numbers::pi_v<float> * (static_cast<float>(j) + 0.5F) / kTurns;
      const float across = std::sqrt(square);
      seen += isHidden({across * sineOf(turn), up, across * cosineOf(turn)}) ? 0 : 1;
    }
  }
  return static_cast<float>(seen) / (kHeights * kTurns);
}

/// Returns whether a ray meets a board or the spine below its edge.
bool meets(float distance, float speed, float up) {
  return speed > 0 && distance * up < kHardback.headInset * speed;
}

TEST(BookLight, OfLeavesIsWhatBoardsAndSpineDontHide) {
  float farthest = 0;
  for (const float x : {3.5F, 6.0F, 12.0F, 100.0F}) {
    for (const float z : {3.2F, 5.0F, 9.0F, 25.0F, 40.0F, 46.5F}) {
      const float seen = seenShare([&](const Vector3f& ray) {
        return meets(kHardback.thickness - kHardback.board - z, ray.z(), ray.y()) ||
               meets(z - kHardback.board, -ray.z(), ray.y()) ||
               meets(x - kHardback.board, -ray.x(), ray.y());
      });
      const float apart = outlookOfLeafEnds(kHardback, x, z).skyVisibility - seen;
      farthest = std::max(farthest, std::abs(apart));
    }
  }
  EXPECT_LT(farthest, 0.02F);  // measured 0.0121
}

TEST(BookLight, OfTheCaseIsWhatLeavesDontHide) {
  const float along = kHardback.width / 2, across = kHardback.height / 2;
  const float leaves = kHardback.width - kHardback.foreEdgeInset;
  EXPECT_EQ(outlookBesideLeaves(kHardback, along, 1).away, Vector3f(0, -0.5F, 0));
  EXPECT_EQ(outlookBesideLeaves(kHardback, along, kHardback.height - 1).away, Vector3f(0, 0.5F, 0));
  EXPECT_EQ(outlookBesideLeaves(kHardback, leaves + 1, across).away, Vector3f(0.5F, 0, 0));
  EXPECT_EQ(outlookBesideLeaves(kHardback, along, 1).skyVisibility, 0.5F);
  EXPECT_EQ(outlookBesideLeaves(kHardback, leaves + 2, 1).skyVisibility, 0.75F) << "at the corner";
}

TEST(BookLight, OfTheForeEdgeComesFromItsMiddle) {
  const float x = kHardback.width - kHardback.foreEdgeInset,
              front = kHardback.thickness - kHardback.board;
  const Outlook beside = outlookOfForeEdge(kHardback, x, front, {1, 0, 0});
  EXPECT_NEAR(beside.skyVisibility, 0.5F, 1e-3F);  // measured 0.4992
  EXPECT_LT(beside.away.z(), -0.49F);
  EXPECT_NEAR(outlookOfForeEdge(kHardback, x, kHardback.thickness / 2, {1, 0, 0}).away.norm(), 0,
              1e-6F);
}

}  // namespace
}  // namespace rotatebook::geometry
