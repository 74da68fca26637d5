#include "overlay/body_box.h"

#include <gtest/gtest.h>

#include "overlay/motion.h"

namespace rotatebook::overlay {
namespace {

const Eigen::Vector3d kEye(0, 0, 2);

TEST(BodyBox, HidesWhatIsInItOrBehindIt) {
  const body::Cuboid body{{2, 2, 1}, 1};
  const BodyBox box(body, body.corners());
  EXPECT_TRUE(box.hides({0, 0, 0}, kEye));
  EXPECT_TRUE(box.hides({0.5, 0.5, -3}, kEye));
  EXPECT_FALSE(box.hides({0, 0, 0.6}, kEye));
  EXPECT_FALSE(box.hides({3, 0, 0}, kEye));
  EXPECT_FALSE(box.hides({0, 5, -3}, kEye));
}

TEST(BodyBox, TurnsAndStretchesWithTheBody) {
  const body::Cuboid body{{2, 2, 1}, 1};
  const Eigen::Vector3d behind(1.3, 0, 0.3);
  EXPECT_FALSE(BodyBox(body, body.corners()).hides(behind, kEye));
  const Eigen::Matrix3d stretch = Eigen::Vector3d(1.5, 1, 1).asDiagonal();
  const BodyBox wide(body, stretch * body.corners());
  EXPECT_TRUE(wide.hides(behind, kEye));
  EXPECT_LT((wide.map() - stretch).norm(), 1e-12);
}

TEST(Projector, FindsTheCamera) {
  const scene::Scene scene = testing::tumbling();
  for (const int bottomRows : {0, 200}) {
    const Projector projector(testing::clipFromWorld(scene, bottomRows), 1280, 720);
    EXPECT_LT((projector.eye() - scene.cameraPosition).norm(), 1e-9);
    const auto middle = projector(scene.camera.target);
    ASSERT_TRUE(middle);
    EXPECT_LT((*middle - Point(640, (720 - bottomRows) / 2.0)).norm(), 1e-9);
  }
}

TEST(Projector, ShowsNothingThatIsBehindTheCamera) {
  const scene::Scene scene = testing::tumbling();
  const Projector projector(testing::clipFromWorld(scene, 0), 1280, 720);
  EXPECT_FALSE(projector(2 * scene.cameraPosition));
}

}  // namespace
}  // namespace rotatebook::overlay
