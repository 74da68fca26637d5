#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bridge/bridge.h"
#include "browser/bridge/bridge_slots.h"
#include "geometry/camera.h"
#include "physics/motion_start.h"
#include "rigid/poinsot.h"
#include "scene/body_forces.h"
#include "scene/scene_text.h"
#include "timeline/scene_camera.h"
#include "timeline/simulate_scene.h"
#include "timeline/spin.h"

namespace rotatebook::bridge {
namespace {

using Eigen::Vector3d;

constexpr int kFrame = 100;
constexpr std::string_view kTurningScene =
    "[simulation]\nmodel = \"exact\"\n"
    "[initial]\nangular_velocity = [5.0, 0.0, 0.0]\ntilt = [0.1, \"z\"]\n"
    "attitude = [1, 0.2, 0.3, 0.4]\n[clip]\nduration = 4\n";

std::string inFrame(std::string_view frame) {
  return std::string(kTurningScene) + "[camera]\nframe = \"" + std::string(frame) + "\"\n";
}

/// A scene in slot 0, and the same by the program's own functions.
struct Played {
  explicit Played(const std::string& text)
      : scene(scene::parseScene(text, "scene.toml")), motion(timeline::simulateScene(scene)) {
    testing::read(0, text);
    rb_advance(context(), 0, testing::kAll, testing::kAll);
  }
  const scene::Panel& panel() const { return scene.motions[0]; }
  const std::vector<physics::Sample>& samples() const { return motion.trajectories()[0].samples; }

  scene::Scene scene;
  timeline::ClipMotion motion;
};

template <typename Function, typename... Values>
std::vector<double> numbersOf(const Function& function, Values... values) {
  std::int32_t count = 7;
  const double* numbers = function(context(), 0, 0, values..., &count);
  if (numbers == nullptr) return {};
  return {numbers, numbers + count};
}

Vector3d vectorAt(const std::vector<double>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

TEST(WhyNumbers, HaveTheForcesOfTheProgram) {
  for (const char* name : {"world", "body", "turning", "momentum"}) {
    const Played played(inFrame(name));
    const scene::MotionFrame frame = referenceFramesOf(played.scene)[0];
    const scene::BodyForces forces(played.panel(), frame);
    const physics::Sample seen = frame.seen(played.samples()[kFrame]);
    const std::vector<double> numbers = numbersOf(rb_forces, kFrame);
    ASSERT_EQ(numbers.size(), 1 + 8 * 15U) << name;
    double largest = 0;
    for (const physics::Sample& sample : played.samples())
      largest = std::max(largest, forces.largestAt(sample));
    EXPECT_EQ(numbers[0], largest) << name;
    for (std::size_t i = 0; i < 8; ++i) {
      const Vector3d place = seen.attitude * forces.places()[i];
      EXPECT_LT((vectorAt(numbers, 1 + 15 * i) - place).norm(), 1e-15);  // measured 8e-17
      const rigid::ForcesPerMass force = forces.at(seen)[i];
      EXPECT_EQ(vectorAt(numbers, 4 + 15 * i), force.held);
      EXPECT_EQ(vectorAt(numbers, 7 + 15 * i), force.centrifugal);
      EXPECT_EQ(vectorAt(numbers, 10 + 15 * i), force.coriolis);
      EXPECT_EQ(vectorAt(numbers, 13 + 15 * i), force.euler);
    }
  }
}

TEST(WhyNumbers, KeepTheScaleOfForcesFromAThrowThatIsMuchFaster) {
  const Played played(inFrame("body") +
                      "[[nudge]]\nat = 1\nangular_velocity = [50, 0, 0]\naxes = \"body\"\n");
  const scene::BodyForces forces(played.panel(), referenceFramesOf(played.scene)[0]);
  EXPECT_EQ(numbersOf(rb_forces, kFrame)[0], 4 * forces.largestAt(played.samples()[0]));
}

TEST(WhyNumbers, HaveTheLadderOfEnergies) {
  const Played played{std::string(kTurningScene)};
  const std::vector<double> numbers = numbersOf(rb_ladder, kFrame);
  ASSERT_EQ(numbers.size(), 4 + 3 * 4 + 2 * 2 * 61U);
  const Vector3d energies =
      rigid::axisEnergies(physics::modelInertia(played.panel()).moments, 1);  // of y, x, z
  const physics::Sample& sample = played.samples()[kFrame];
  const double energy = sample.total() / sample.angularMomentum.squaredNorm();
  EXPECT_NEAR(numbers[0], (energy - energies.z()) / (energies.y() - energies.z()),
              1e-14);  // measured 5e-16
  EXPECT_NEAR(numbers[1], rigid::reachOfMomentum(energies, energy) / std::numbers::pi,
              1e-13);  // measured 3.5e-15
  EXPECT_LE(std::abs(numbers[2]), numbers[1]);
  EXPECT_NEAR(numbers[3], 100 * (energy / energies.x() - 1), 1e-12);  // measured 8e-14
  const std::array<double, 3> axes{1, 0, 2};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(numbers[4 + 4 * i], axes[i]);
  EXPECT_EQ(numbers[6], 1) << "the smallest moment's axis is at the top";
  EXPECT_EQ(numbers[11], 0.5) << "on the middle rung L goes half a turn";
  EXPECT_EQ(numbers[14], 0);
  EXPECT_EQ(numbers[16], 1) << "the outline begins at the top";
}

TEST(WhyNumbers, HavePoinsotsConstruction) {
  const Played played(inFrame("momentum"));
  const std::vector<double> numbers = numbersOf(rb_poinsot, kFrame, 30);
  constexpr std::size_t kHead = 25;
  ASSERT_EQ(numbers.size(), kHead + 31 * 6U);
  const Vector3d centre = vectorAt(numbers, 4), normal = vectorAt(numbers, 22);
  EXPECT_LT((normal - Vector3d::UnitY()).norm(), 1e-15);  // measured 1.4e-17
  EXPECT_EQ(numbers[3], played.panel().body.largestDimension() / 2);
  // The points lie in the plane, between the two radii, and the two curves meet in the last one.
  for (std::size_t i = kHead; i < numbers.size(); i += 6) {
    const Vector3d point = vectorAt(numbers, i + 3) - centre;
    EXPECT_NEAR(point.dot(normal), numbers[0], 1e-15);  // measured 6e-17
    const double radius = (point - numbers[0] * normal).norm();
    EXPECT_GT(radius, numbers[1] - 1e-12);
    EXPECT_LT(radius, numbers[2] + 1e-12);
  }
  const std::size_t last = numbers.size() - 6;
  EXPECT_LT((vectorAt(numbers, last) - vectorAt(numbers, last + 3)).norm(),
            1e-16);  // measured 2.5e-18
  // The ellipsoid is the image of the unit sphere, and touches the plane there.
  Eigen::Matrix3d map;
  map << vectorAt(numbers, 7), vectorAt(numbers, 10), vectorAt(numbers, 13);
  const Vector3d unit = map.inverse() * (vectorAt(numbers, last) - centre);
  EXPECT_NEAR(unit.norm(), 1, 1e-15);  // measured 0
  EXPECT_LT((map.transpose().inverse() * unit).normalized().cross(normal).norm(),
            1e-14);  // measured 4e-16
}

TEST(WhyNumbers, BeginTheTrailAtTheLastNudge) {
  const Played played(std::string(kTurningScene) +
                      "[[nudge]]\nat = 1.5\nangular_velocity = [0, 1, 0]\naxes = \"body\"\n");
  EXPECT_EQ(numbersOf(rb_poinsot, kFrame, 60).size(), 25 + 11 * 6U);
  EXPECT_EQ(numbersOf(rb_poinsot, 89, 60).size(), 25 + 61 * 6U);
}

TEST(WhyNumbers, SayWhatFollowsFromAThrow) {
  const Played played{std::string(kTurningScene)};
  const timeline::Spin spin = timeline::spinOf(played.panel());
  const std::int32_t length = rb_spin(context(), 0, 0);
  ASSERT_GT(length, 0);
  const std::string json = testing::taken(length);
  using ::testing::HasSubstr;
  EXPECT_THAT(json, HasSubstr("{\"speed\":5.0,\"axis\":\"middle\",\"offAxis\":5.7295779"));
  EXPECT_THAT(json, HasSubstr("\"isSteady\":false,\"hasEqualMoments\":false"));
  EXPECT_NEAR(std::stod(json.substr(json.find("flipInterval") + 14)), *spin.flipInterval(), 0);
  EXPECT_NEAR(std::stod(json.substr(json.find("firstFlip") + 11)), *spin.firstFlip, 0);
}

// A wall that stands still is seen turned by a camera that turns, and by no other.
TEST(WhyNumbers, HaveTheSkyOfACameraThatTurns) {
  const std::array<double, 2> straight{0, 0};
  std::array<float, 16> matrix{}, sky{};
  std::array<float, 3> eye{};
  for (const char* name : {"world", "body", "turning"}) {
    const Played played(inFrame(name));
    rb_camera(context(), 0, 0, kFrame, 640, 360, straight.data(), 1, matrix.data(), eye.data(),
              sky.data());
    const Eigen::Matrix4d here = Eigen::Map<Eigen::Matrix4f>(sky.data()).cast<double>();
    if (name != std::string_view("turning")) {
      EXPECT_EQ(here.norm(), 0) << name;
      continue;
    }
    const geometry::Screen screen{640, 360, 0};
    const auto frame = referenceFramesOf(played.scene)[0];
    const Eigen::Matrix4d there =
        geometry::skyFromPicture(timeline::cameraOf(played.scene, screen), screen,
                                 frame.fromWorld(played.samples()[kFrame]).transpose());
    EXPECT_LT((here - there).norm(), 1e-6);  // measured 3.6e-8
    EXPECT_GT((here.block<3, 1>(0, 2) + Vector3d::UnitZ()).norm(), 0.1) << "it is turned";
  }
}

TEST(WhyNumbers, AreNoneOfWhatIsntThere) {
  const Played played{std::string(kTurningScene)};
  std::int32_t count = 7;
  EXPECT_EQ(rb_forces(context(), 0, 1, 0, &count), nullptr);
  EXPECT_EQ(count, 0);
  EXPECT_EQ(rb_ladder(context(), 0, -1, 0, &count), nullptr);
  EXPECT_EQ(rb_poinsot(context(), -1, 0, 0, 5, &count), nullptr);
  EXPECT_LT(rb_spin(context(), 0, 1), 0);
  EXPECT_EQ(numbersOf(rb_poinsot, testing::kAll, testing::kAll).size(), 25 + 240 * 6U);
}

}  // namespace
}  // namespace rotatebook::bridge
