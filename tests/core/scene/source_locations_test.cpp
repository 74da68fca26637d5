#include "scene/source_locations.h"

#include <string>

#include <gtest/gtest.h>

#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

TEST(Places, AreThoseThatTheFileStates) {
  const Scene scene =
      sceneFrom("title = 'A'\n[book]\nspine = 's.png'\n[overlay]\nshow = []\nfont = 'Lato'");
  EXPECT_EQ(locationOf(scene, "title"), "a.toml:1:9");
  EXPECT_EQ(locationOf(scene, "book.spine"), "a.toml:3:9");
  EXPECT_EQ(locationOf(scene, "overlay.font"), "a.toml:6:8");
}

TEST(Places, AreThoseOfTheLabels) {
  const Scene scene = sceneFrom("[[panel]]\nlabel = 'one'\n[[panel]]\nlabel = 'two'\n");
  EXPECT_EQ(locationOf(scene, labelKey(0)), "a.toml:2:9");
  EXPECT_EQ(locationOf(scene, labelKey(1)), "a.toml:4:9");
}

TEST(Places, AreTheScenesNameForDefaults) {
  const Scene scene = sceneFrom("");
  EXPECT_EQ(locationOf(scene, "caption"), scene.name);
  EXPECT_EQ(locationOf(scene, "book.front"), scene.name);
}

TEST(Places, ArePutBeforeWhatIsWrongThere) {
  const Scene scene = sceneFrom("caption = 'B'");
  const auto failing = []() -> int { throw InputError("it is too long"); };
  EXPECT_EQ(atLocationOf(scene, "caption", [] { return 7; }), 7);
  try {
    atLocationOf(scene, "caption", failing);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "a.toml:1:11: it is too long");
  }
}

}  // namespace
}  // namespace rotatebook::scene
