#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/parse.h"
#include "scene/scene_text.h"

namespace rotatebook::scene {
namespace {

using physics::Nudge;
using physics::SpinKind;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string kLate = "[[nudge]]\nat = '5 s'\nangular_velocity = ['60 deg/s', 0, 0]\n";
const std::string kEarly = "[[nudge]]\nat = 2.5\nangular_momentum = [0, 0.01, 0]\naxes = 'world'\n";

std::vector<Nudge> nudgesFrom(const std::string& text) {
  return sceneFrom(text).motions[0].nudges;
}

TEST(Nudges, AreNoneUnlessStated) {
  EXPECT_THAT(nudgesFrom(""), IsEmpty());
}

TEST(Nudges, AreReadInTheOrderOfTheirTimes) {
  const std::vector<Nudge> nudges = nudgesFrom(kLate + kEarly);
  ASSERT_EQ(nudges.size(), 2U);
  EXPECT_EQ(nudges[0], (Nudge{2.5, SpinKind::AngularMomentum, {0, 0.01, 0}, Nudge::Axes::World}));
  EXPECT_EQ(nudges[1].at, 5);
  EXPECT_EQ(nudges[1].kind, SpinKind::AngularVelocity);
  EXPECT_NEAR(nudges[1].value.x(), 1.0471975511965976, 1e-15);
  EXPECT_EQ(nudges[1].axes, Nudge::Axes::Body);
}

TEST(Nudges, ArePrintedSoThatTheyAreReadAgain) {
  const std::string spin = "[initial]\nangular_velocity = [0, 0, 6]\n";
  const Scene scene = parseScene(spin + kLate + kEarly, "a.toml");
  EXPECT_EQ(parseScene(sceneText(scene), "a.toml").motions[0].nudges, scene.motions[0].nudges);
}

TEST(Nudges, OfThePanelsAreTheScenesOrTheirOwn) {
  const Scene scene =
      parseScene("[initial]\nangular_velocity = [0, 0, 6]\n" + kEarly +
                     "[[panel]]\nlabel = 'one'\n[[panel]]\nlabel = 'two'\n[[panel.nudge]]\nat = 7\n"
                     "angular_velocity = [0, 0, 1]\n",
                 "a.toml");
  EXPECT_EQ(scene.motions[0].nudges, nudgesFrom(kEarly));
  ASSERT_EQ(scene.motions[1].nudges.size(), 1U);
  EXPECT_EQ(scene.motions[1].nudges[0].at, 7);
  EXPECT_EQ(parseScene(sceneText(scene), "a.toml").motions, scene.motions);
}

TEST(Nudges, NeedATimeAndOneSpin) {
  EXPECT_EQ(errorOf("[[nudge]]\nangular_velocity = [1, 0, 0]"),
            "a.toml:1:1: [[nudge]] needs at, its time in s");
  EXPECT_EQ(errorOf("[[nudge]]\nat = 1"),
            "a.toml:1:1: [[nudge]] needs angular_velocity or angular_momentum, what it adds to "
            "the spin");
  EXPECT_EQ(errorOf("[[nudge]]\nat = 1\nangular_velocity = [1, 0, 0]\nangular_momentum = [1, 0, "
                    "0]"),
            "a.toml:1:1: [[nudge]] has both angular_velocity and angular_momentum; keep one of "
            "them");
  EXPECT_EQ(errorOf("[[nudge]]\nat = 0\nangular_velocity = [1, 0, 0]"),
            "a.toml:2:6: nudge.at must be a time over 0 and up to 1e100 s, not 0");
}

TEST(Nudges, AreLimitedInNumber) {
  std::string many;
  for (int i = 0; i < 101; ++i) many += kEarly;
  EXPECT_EQ(errorOf(many), "a.toml:1:1: a motion has up to 100 nudges, not 101");
}

}  // namespace
}  // namespace rotatebook::scene
