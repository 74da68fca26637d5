// Poinsot's construction on pictures of the book of scenes/starter.toml, against places that were
// computed independently.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "overlay/motion.h"
#include "overlay/palette.h"
#include "overlay/projector.h"

namespace rotatebook::overlay {
namespace {

// From the ellipsoid to the picture, half of the book's longest edge over the longest semi-axis.
constexpr double kMetres = 0.5 * 0.29085 / 17.82476446;
constexpr double kDistance = 11.7371581102;  // of the plane, before that scale

struct KnownContact {
  double time;
  Eigen::Vector3d place;  // in the world, before the scale
};
const KnownContact kContacts[] = {{0, {11.73562335, 0, 0.20484607}},
                                  {1, {11.77664298, -0.25713591, -1.50270458}},
                                  {2.5, {11.74731972, 1.05690832, -0.28204623}}};

scene::Scene starterWith(const std::string& more) {
  return scene::parseScene(
      "simulation.model = 'exact'\noverlay.show = ['poinsot']\n[initial]\n"
      "angular_velocity = [5, 0, 0]\ntilt = ['1 deg', 'z']\n[clip]\nfps = 50\nduration = 3\n"
      "size = [1280, 720]\n" +
          more,
      "starter.toml");
}

/// Returns how far the colour at a place of the world is from `wanted`, 0 to 1.
double differenceAt(const image::Image& picture, const scene::Scene& scene,
                    const Eigen::Vector3d& place, const Colour& wanted) {
  const Projector projector(testing::clipFromWorld(scene, 0), scene.clip.width, scene.clip.height);
  const Point at = *projector(place);
  const std::uint8_t* pixel =
      picture.row(static_cast<int>(at.y())) + 4 * static_cast<std::ptrdiff_t>(at.x());
  const double colour[] = {wanted.red, wanted.green, wanted.blue};
  double largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(pixel[i] / 255.0 - colour[i]));
  return largest;
}

TEST(PoinsotOverlay, HasItsContactPointWhereItIsKnownToBe) {
  const scene::Scene scene = starterWith("");
  for (const KnownContact& drawn : kContacts) {
    const image::Image picture =
        testing::drawn(scene, static_cast<std::int64_t>(std::lround(50 * drawn.time)));
    for (const KnownContact& other : kContacts) {
      const double difference = differenceAt(picture, scene, kMetres * other.place, kWhite);
      if (other.time == drawn.time) {
        EXPECT_LT(difference, 0.005) << drawn.time;
      } else {
        EXPECT_GT(difference, 0.05) << drawn.time << ", " << other.time;
      }
    }
  }
}

// Where the normal through the centre meets it.
TEST(PoinsotOverlay, HasItsPlaneAtRestInTheWorld) {
  const scene::Scene scene = starterWith("");
  const Eigen::Vector3d momentum = testing::motionOf(scene).samples[0].angularMomentum;
  for (const std::int64_t frame : {50, 125}) {
    const image::Image picture = testing::drawn(scene, frame);
    const Eigen::Vector3d foot = kMetres * kDistance * momentum.normalized();
    EXPECT_LT(differenceAt(picture, scene, foot, kMomentumColour), 0.005);
    EXPECT_GT(differenceAt(picture, scene, 1.05 * foot, kMomentumColour), 0.1);
  }
}

TEST(PoinsotOverlay, BeginsItsCurvesAnewAfterANudge) {
  const auto drawn = [](const std::string& nudge) {
    return testing::drawn(
        starterWith("[[nudge]]\nat = " + nudge + "\nangular_velocity = [0, 0, 0.5]\n"), 60);
  };
  EXPECT_NE(drawn("0.5"), drawn("2.5"));
  const scene::Scene scene = starterWith("[[nudge]]\nat = 1\nangular_velocity = [0, 2, 0]\n");
  // At the nudge there is a contact point, but no curve yet; its first one is where it was before.
  const Eigen::Vector3d before = kMetres * kContacts[0].place;
  const image::Image picture = testing::drawn(scene, 51);
  EXPECT_GT(differenceAt(picture, scene, before, kMomentumColour), 0.1);
}

TEST(PoinsotOverlay, IsNothingOfABodyAtRest) {
  const scene::Scene scene = starterWith("");
  physics::Trajectory trajectory = testing::motionOf(scene);
  trajectory.samples.resize(2);
  for (physics::Sample& sample : trajectory.samples) sample.angularMomentum.setZero();
  MotionOverlays overlays = testing::overlaysOf(scene, trajectory);
  EXPECT_EQ(testing::drawn(overlays, scene, 1), testing::greyPicture(scene));
}

}  // namespace
}  // namespace rotatebook::overlay
