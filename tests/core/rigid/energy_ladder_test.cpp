#include "rigid/energy_ladder.h"

#include <numbers>

#include <gmock/gmock.h>

#include "rigid/poinsot.h"

namespace rotatebook::rigid {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

// Of the paper's book. [kg m^2]
const Eigen::Vector3d kMoments(0.0072578, 0.0031473, 0.0099884);

constexpr double kRightAngle = std::numbers::pi / 2;

TEST(EnergyLadder, HasTheSmallestMomentsAxisAtItsTop) {
  const EnergyLadder ladder(kMoments);
  EXPECT_THAT(ladder.axes(), ElementsAre(1, 0, 2));
  EXPECT_EQ(ladder.heightOf(ladder.energyOf(1)), 1);
  EXPECT_EQ(ladder.heightOf(ladder.energyOf(2)), 0);
  EXPECT_EQ(ladder.heightOf(2 * ladder.energyOf(1)), 1);
  EXPECT_NEAR(ladder.aboveMiddle(ladder.energyOf(1)), kMoments[0] / kMoments[1] - 1, 1e-15);
}

TEST(EnergyLadder, IsAsWideAsMotionsWander) {
  const EnergyLadder ladder(kMoments);
  EXPECT_EQ(ladder.reachAt(ladder.energyOf(1)), 0);
  EXPECT_EQ(ladder.reachAt(ladder.energyOf(0)), kRightAngle);
  // L through the plane of the circled and the middle axis is at the outline.
  for (const int circled : {1, 2}) {
    for (const double angle : {0.1, 0.7, -1.2}) {
      Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
      momentum[circled] = -std::cos(angle);
      momentum[0] = std::sin(angle);
      const double energy = momentum.cwiseAbs2().cwiseQuotient(kMoments).sum() / 2;
      const LadderPlace place = ladder.placeOf(momentum, energy);
      EXPECT_NEAR(place.angle, angle, 1e-13);  // measured 7e-15
      EXPECT_NEAR(ladder.reachAt(energy), std::abs(angle), 1e-13);
      EXPECT_EQ(place.height, ladder.heightOf(energy));
    }
  }
}

TEST(EnergyLadder, HasAnOutlineFromTheTopToTheFoot) {
  const std::vector<LadderPlace> outline = EnergyLadder(kMoments).outline();
  EXPECT_EQ(outline.front().height, 1);
  EXPECT_THAT(outline.front().angle, DoubleNear(0, 1e-7));
  EXPECT_EQ(outline.back().height, 0);
  double widest = 0;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    EXPECT_LE(outline[i].height, outline[i - 1].height);
    widest = std::max(widest, outline[i].angle);
  }
  EXPECT_NEAR(widest, kRightAngle, 1e-7);
}

TEST(EnergyLadder, OfABallIsOneRung) {
  const EnergyLadder ladder(Eigen::Vector3d::Constant(0.01));
  EXPECT_EQ(ladder.heightOf(ladder.energyOf(0)), 0.5);
  EXPECT_EQ(ladder.reachAt(ladder.energyOf(0)), 0);
}

}  // namespace
}  // namespace rotatebook::rigid
