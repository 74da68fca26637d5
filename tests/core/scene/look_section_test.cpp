#include <string>

#include <gtest/gtest.h>

#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

TEST(LookSection, ReadsEveryKey) {
  const Scene plain = sceneFrom("");
  EXPECT_EQ(plain.look.background, Background::Studio);
  EXPECT_EQ(plain.look.supersample, 1);
  EXPECT_EQ(plain.look.motionBlur, 1);
  EXPECT_TRUE(plain.look.body);
  EXPECT_TRUE(plain.overlay.band);
  const Scene scene = sceneFrom(
      "[look]\nbackground = 'stars'\nsupersample = 2\nmotion_blur = 4\nbody = false\n"
      "[overlay]\nband = false");
  EXPECT_EQ(scene.look.background, Background::Stars);
  EXPECT_EQ(scene.look.supersample, 2);
  EXPECT_EQ(scene.look.motionBlur, 4);
  EXPECT_FALSE(scene.look.body);
  EXPECT_FALSE(scene.overlay.band);
}

TEST(LookSection, MayHaveABackgroundOfOneColour) {
  const LookSettings white = sceneFrom("look.background = 'white'").look;
  EXPECT_EQ(white.background, Background::Plain);
  EXPECT_EQ(white.plainColour, (Rgb{255, 255, 255}));
  EXPECT_EQ(sceneFrom("look.background = '#0102ff'").look.plainColour, (Rgb{1, 2, 255}));
  EXPECT_EQ(sceneFrom("look.background = 'white'", {"look.background=stars"}).look.background,
            Background::Stars);
}

TEST(LookSection, RefusesWhatThereIsNot) {
  EXPECT_EQ(
      errorOf("[look]\nbackground = 'star'"),
      "a.toml:2:14: look.background must be \"studio\", \"stars\", \"transparent\", \"white\", "
      "\"black\" or a colour such as \"#2b5d8a\", not \"star\"; did you mean \"stars\"?");
  EXPECT_TRUE(errorOf("[look]\nbackground = 'whit'").ends_with("; did you mean \"white\"?"));
  EXPECT_EQ(errorOf("[look]\nsupersample = 3"),
            "a.toml:2:15: look.supersample must be an integer from 1 to 2, not 3");
  EXPECT_EQ(errorOf("[look]\nmotion_blur = 6"),
            "a.toml:2:15: look.motion_blur must be 1, 2, 4, 8 or 16, not 6");
  EXPECT_EQ(errorOf("[look]\nmotion_blur = 32"),
            "a.toml:2:15: look.motion_blur must be an integer from 1 to 16, not 32");
  EXPECT_EQ(errorOf("[look]\nbody = 'no'"),
            "a.toml:2:8: look.body must be true or false, not \"no\"");
  EXPECT_EQ(errorOf("[overlay]\nband = 0"),
            "a.toml:2:8: overlay.band must be true or false, not 0");
}

}  // namespace
}  // namespace rotatebook::scene
