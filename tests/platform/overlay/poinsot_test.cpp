// Poinsot's construction on pictures of the book of scenes/starter.toml, against places that were
// computed independently.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "overlay/body_box.h"
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

/// Returns how much more red than green there is at a place of the world: the plane is the only
/// area that has it.
int rednessAt(const image::Image& picture, const Point& at) {
  const std::uint8_t* pixel =
      picture.row(static_cast<int>(at.y())) + 4 * static_cast<std::ptrdiff_t>(at.x());
  return pixel[0] - pixel[1];
}

/// Of 60 places of the plane.
struct PlaneSeen {
  int hidden = 0;  // by the body
  int wrong = 0;   // drawn although hidden, or not drawn
};

PlaneSeen planeSeen(const std::string& position, std::int64_t frame) {
  const scene::Scene scene = starterWith("[camera]\nposition = " + position + "\n");
  const physics::Sample sample = testing::motionOf(scene).samples[static_cast<std::size_t>(frame)];
  const BodyBox box(scene.motions[0].body, sample.cage);
  const Eigen::Vector3d normal = sample.angularMomentum.normalized();
  const Eigen::Vector3d a = normal.unitOrthogonal(), b = normal.cross(a);
  const Projector projector(testing::clipFromWorld(scene, 0), scene.clip.width, scene.clip.height);
  const image::Image picture = testing::drawn(scene, frame);
  PlaneSeen seen;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.1 * i, radius = kMetres * 8.3;  // between the rings and the ticks
    const Eigen::Vector3d place =
        kMetres * kDistance * normal + radius * (std::cos(angle) * a + std::sin(angle) * b);
    const bool isHidden = box.hides(place, projector.eye());
    if (isHidden) ++seen.hidden;
    if ((rednessAt(picture, *projector(place)) <= 0) != isHidden) ++seen.wrong;
  }
  return seen;
}

TEST(PoinsotOverlay, HasItsPlaneBehindTheBodyWhereTheBodyIsInFront) {
  const PlaneSeen before = planeSeen("[-0.2, 0.6, 0.3]", 70);
  EXPECT_EQ(before.hidden, 51);
  EXPECT_LE(before.wrong, 2);  // measured 1, at the body's edge; 51 without depth
  // From beyond the plane the body hides only where it reaches through.
  const PlaneSeen beyond = planeSeen("[0.3, 0.1, 0.6]", 50);
  EXPECT_EQ(beyond.hidden, 6);
  EXPECT_LE(beyond.wrong, 2);  // measured 0; 6 without depth
}

TEST(PoinsotOverlay, BeginsItsCurvesAnewAfterANudge) {
  const scene::Scene scene = starterWith(
      "[camera]\nposition = [0.6, 0.2, 0.2]\n[[nudge]]\nat = 1\n"
      "angular_velocity = [0, 1, 1]\n");
  const auto samples = testing::motionOf(scene).samples;
  const Projector projector(testing::clipFromWorld(scene, 0), scene.clip.width, scene.clip.height);
  const auto contact = [&](std::size_t n) {
    return Eigen::Vector3d(kMetres * samples[n].angularVelocity /
                           std::sqrt(2 * samples[n].kinetic));
  };
  const image::Image picture = testing::drawn(scene, 90);
  EXPECT_LT(differenceAt(picture, scene, contact(90), kWhite), 0.005);
  const auto rednessOf = [&](std::size_t n) { return rednessAt(picture, *projector(contact(n))); };
  int before = 0, after = 255;
  for (std::size_t n = 0; n < 50; n += 2) before = std::max(before, rednessOf(n));
  for (std::size_t n = 52; n < 90; n += 2) after = std::min(after, rednessOf(n));
  EXPECT_LT(before, 30);  // measured 11
  EXPECT_GT(after, 40);   // measured 66
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
